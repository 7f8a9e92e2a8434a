#include "model/picture/prescaled.h"

#include "model/picture/byte_pixels.h"

#include <algorithm>
#include <numeric>

namespace {
// Positions where neighbouring columns or rows differ: their greatest common divisor and their
// number.
struct Changes {
    int divisor = 0;
    int count = 0;

    void add(int position) {
        divisor = std::gcd(divisor, position);
        ++count;
    }
};

bool is_row_new(const Picture& picture, int y) {
    const auto row = picture.pixels.begin() + static_cast<std::ptrdiff_t>(picture.index(0, y));
    const auto length = static_cast<std::ptrdiff_t>(picture.index(0, 1));
    return !std::equal(row, row + length, row - length);
}

bool is_column_new(const Picture& picture, int x) {
    const auto channels = static_cast<std::ptrdiff_t>(picture.channels);
    for (int y = 0; y < picture.extent.height; ++y) {
        const auto pixel =
            picture.pixels.begin() + static_cast<std::ptrdiff_t>(picture.index(x, y));
        if (!std::equal(pixel, pixel + channels, pixel - channels))
            return true;
    }
    return false;
}

// Stops when the divisor is 1.
template <class IsNew>
Changes changes_along(int length, const IsNew& is_new) {
    Changes changes{length};
    for (int position = 1; position < length && changes.divisor > 1; ++position)
        if (is_new(position))
            changes.add(position);
    return changes;
}
}  // namespace

int found_prescale(const Picture& given) {
    const Picture floats = given.bytes ? with_floats(given) : Picture();
    const Picture& picture = given.bytes ? floats : given;
    constexpr int largest = 8;
    constexpr int min_changes = 8;
    const Changes rows =
        changes_along(picture.extent.height, [&](int y) { return is_row_new(picture, y); });
    if (rows.divisor <= 1 || rows.count < min_changes)
        return 1;
    const Changes columns =
        changes_along(picture.extent.width, [&](int x) { return is_column_new(picture, x); });
    if (columns.count < min_changes)
        return 1;
    const int common = std::gcd(rows.divisor, columns.divisor);
    for (int times = largest; times > 1; --times)
        if (common % times == 0)
            return times;
    return 1;
}

Extent extent_without_prescale(Extent extent, int times) {
    return {std::max(extent.width / times, 1), std::max(extent.height / times, 1)};
}

Picture without_prescale(const Picture& picture, int times) {
    Picture original = {extent_without_prescale(picture.extent, times),
                        picture.channels,
                        picture.encoding,
                        {},
                        picture.shape,
                        picture.note};
    if (picture.bytes)
        original.channels = 3;
    original.pixels.reserve(original.index(0, original.extent.height));
    for (int y = 0; y < original.extent.height; ++y)
        for (int x = 0; x < original.extent.width; ++x) {
            const int from_x = std::min(x * times + times / 2, picture.extent.width - 1);
            const int from_y = std::min(y * times + times / 2, picture.extent.height - 1);
            if (picture.bytes) {
                const std::uint8_t* const bytes = bytes_at(picture, from_x, from_y);
                for (const int c : {2, 1, 0})
                    original.pixels.push_back(float_of(bytes[c]));
                continue;
            }
            const auto pixel =
                picture.pixels.begin() + static_cast<std::ptrdiff_t>(picture.index(from_x, from_y));
            original.pixels.insert(original.pixels.end(), pixel, pixel + picture.channels);
        }
    return original;
}
