#include "model/picture/flash_log.h"

#include "model/look/color.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr int samples_per_row = 8;  // samples per row of a cell

float light_of(float stored, Encoding encoding) {
    if (!(stored > 0.0f))  // NaN too
        return 0.0f;
    const double number = std::min(static_cast<double>(stored), 1.0);
    return static_cast<float>(encoding == Encoding::display ? srgb_decode(number) : number);
}

// For all values of 8 or 16 bits.
template <class Number>
struct KnownLights {
    explicit KnownLights(Encoding encoding) : lights(std::size_t{1} << (8 * sizeof(Number))) {
        for (std::size_t bits = 0; bits < lights.size(); ++bits)
            lights[bits] = light_of(number_of(static_cast<Number>(bits)), encoding);
    }
    std::vector<float> lights;
};

template <class Number>
const float* known_lights(Encoding encoding) {
    static const KnownLights<Number> linear(Encoding::linear);
    static const KnownLights<Number> display(Encoding::display);
    return (encoding == Encoding::linear ? linear : display).lights.data();
}

// `light` returns a channel of the pixel at x, y from the top left.
template <class LightAt>
std::vector<Light> cells_by(Extent extent, const LightAt& light) {
    std::vector<Light> cells(static_cast<std::size_t>(flash_cells.width * flash_cells.height));
    if (extent.is_empty())
        return cells;
    const int columns = flash_cells.width * samples_per_row;
    const int rows = flash_cells.height * samples_per_row;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int x = (2 * column + 1) * extent.width / (2 * columns);
            const int y = (2 * row + 1) * extent.height / (2 * rows);
            const int index = row / samples_per_row * flash_cells.width + column / samples_per_row;
            Light& cell = cells[static_cast<std::size_t>(index)];
            for (std::size_t i = 0; i < 3; ++i)
                cell[i] += light(x, y, i) / static_cast<float>(samples_per_row * samples_per_row);
        }
    return cells;
}
}  // namespace

std::vector<Light> cells_of(const Picture& picture) {
    return cells_by(picture.extent, [&](int x, int y, std::size_t channel) {
        const std::size_t at = picture.index(x, y) + (picture.channels >= 3 ? channel : 0);
        return light_of(picture.pixels[at], picture.encoding);
    });
}

std::vector<Light> cells_of(const RawPicture& picture) {
    const auto index_of = [&](int x, int y, std::size_t channel) {
        const auto row = static_cast<std::size_t>(picture.extent.height - 1 - y);
        return row * picture.row_length() +
               static_cast<std::size_t>(x) * static_cast<std::size_t>(picture.channels) +
               (picture.channels >= 3 ? channel : 0);
    };
    return std::visit(
        [&]<class Number>(const std::vector<Number>& numbers) {
            if constexpr (sizeof(Number) < sizeof(float)) {
                const float* const lights = known_lights<Number>(picture.encoding);
                return cells_by(picture.extent, [&](int x, int y, std::size_t channel) {
                    return lights[numbers[index_of(x, y, channel)]];
                });
            } else {
                return cells_by(picture.extent, [&](int x, int y, std::size_t channel) {
                    return light_of(numbers[index_of(x, y, channel)], picture.encoding);
                });
            }
        },
        picture.pixels);
}

void FlashLog::add(std::span<const Light> cells, double seconds, const Subframe& subframe) {
    const auto whole = m_subframes.add(subframe, cells);
    if (!whole)
        return;
    const Flashes now = m_counter.add(seconds, *whole);
    m_maximum = {std::max(m_maximum.general, now.general), std::max(m_maximum.red, now.red)};
    if (!now.is_beyond_limit())
        return;
    if (!m_first)
        m_first = seconds;
    m_last = seconds;
    ++m_count;
}

std::optional<std::string> FlashLog::warning() const {
    if (!m_first)
        return std::nullopt;
    const std::string frames =
        m_count == 1 ? fmt::format("1 frame at {:.2f} s is above it.", *m_first)
                     : fmt::format("{} frames from {:.2f} s to {:.2f} s are above it.", m_count,
                                   *m_first, m_last);
    return fmt::format(
        "the picture flashes up to {} times a second ({} in red); the limit of WCAG 2.3.1 is {}. "
        "{}",
        m_maximum.maximum(), m_maximum.red, Flashes::limit, frames);
}
