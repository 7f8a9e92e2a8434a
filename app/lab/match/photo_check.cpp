#include "lab/match/photo_check.h"

#include "io/pictures/picture_file.h"
#include "io/system/machine_memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fs = std::filesystem;

namespace {
// The share of the screen's pixels with a channel at its maximum.
double clipped_share(const Picture& photo, const Corners& corners) {
    const ScreenMap map({.corners = corners}, photo.extent);
    constexpr int count = 256;
    constexpr float highest = 254.0F / 255.0F;
    int clipped = 0;
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < count; ++x) {
            const glm::dvec2 at = map.photo_at((glm::dvec2(x, y) + 0.5) / double{count});
            const int column = std::clamp(static_cast<int>(at.x), 0, photo.extent.width - 1);
            const int row = std::clamp(static_cast<int>(at.y), 0, photo.extent.height - 1);
            const float* rgb = &photo.pixels[photo.index(column, row)];
            clipped += std::max({rgb[0], rgb[1], rgb[2]}) >= highest ? 1 : 0;
        }
    return static_cast<double>(clipped) / (count * count);
}

Result<void> check_exposure(const Picture& photo, const Corners& corners, const fs::path& file) {
    constexpr double most = 0.02;
    const double share = clipped_share(photo, corners);
    if (share <= most)
        return {};
    return fail({file, 0,
                 fmt::format("The photo is overexposed: {:.0f} % of the screen's pixels are at "
                             "their maximum. Take one with less exposure.",
                             100.0 * share)});
}

// The fit keeps squared values and smaller copies of a photo.
Result<void> check_memory(Extent photo, const fs::path& file) {
    constexpr std::uint64_t bytes_per_pixel = 20;
    const auto pixels =
        static_cast<std::uint64_t>(photo.width) * static_cast<std::uint64_t>(photo.height);
    const std::uint64_t most = machine_memory() / 4;
    if (pixels * bytes_per_pixel <= most)
        return {};
    return fail({file, 0,
                 fmt::format("The photo has {} megapixels, which is too much for this machine's "
                             "memory. Make it smaller, but keep at least 3 px per mask stripe.",
                             pixels / 1'000'000)});
}
}  // namespace

Result<Picture> load_photo(const fs::path& file) {
    auto picture = load_picture(file);
    if (!picture)
        return picture;
    if (picture->encoding != Encoding::display)
        return fail({file, 0,
                     "This file has linear light. Give a photo with 8 or 16 bits, such as a JPEG "
                     "or PNG."});
    if (picture->channels < 3)
        return fail({file, 0, "This photo has no colours. Give a colour photo."});
    if (auto fits = check_memory(picture->extent, file); !fits)
        return fail(fits.error());
    return picture;
}

Result<void> check_photo(const Picture& photo, const Corners& corners, const fs::path& file) {
    if (auto good = check_corners(corners, photo.extent); !good)
        return good;
    return check_exposure(photo, corners, file);
}

Extent screen_size(const Corners& corners) {
    const auto side = [&](std::size_t from, std::size_t to) {
        return glm::length(corners[to] - corners[from]);
    };
    const double width = 0.5 * (side(0, 1) + side(3, 2));
    const double height = 0.5 * (side(0, 3) + side(1, 2));
    constexpr std::array aspects{4.0 / 3.0, 5.0 / 4.0, 16.0 / 9.0, 16.0 / 10.0, 3.0 / 4.0};
    constexpr double nearest = 0.08;  // perspective makes sides shorter
    const double seen = width / height;
    double aspect = seen;
    double miss = nearest;
    for (const double usual : aspects)
        if (const double apart = std::abs(seen / usual - 1.0); apart < miss) {
            aspect = usual;
            miss = apart;
        }
    constexpr double most = 1280.0;
    const double shown = std::min(std::max(width, height * aspect), most);
    return {static_cast<int>(std::lround(shown)), static_cast<int>(std::lround(shown / aspect))};
}
