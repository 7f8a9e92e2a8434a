#include "model/photo/sample_layout.h"

#include <algorithm>

namespace {
constexpr Extent most_tiles{8, 6};
constexpr int cells_across = 192;

// Tiles that fit next to each other with their margins.
int fitting(int length, int most) {
    return std::clamp(length / SampleLayout::stride, 1, most);
}

int origin_of(int index, int count, int length) {
    constexpr int taken = SampleLayout::stride;
    const int first = count == 1 ? (length - taken) / 2 : index * (length - taken) / (count - 1);
    return first + SampleLayout::margin;
}
}  // namespace

SampleLayout::SampleLayout(Extent size)
    : picture(size),
      tiles{fitting(size.width, most_tiles.width), fitting(size.height, most_tiles.height)},
      cell_side(std::max((size.width + cells_across / 2) / cells_across, 1)) {
    cells = {std::max(size.width / cell_side - 2 * border, 1),
             std::max(size.height / cell_side - 2 * border, 1)};
    points = {(cells.width + 1) / 2, (cells.height + 1) / 2};
    quarters = {2 * tiles.width, 2 * tiles.height};
}

SampleLayout SampleLayout::dense(Extent size) {
    SampleLayout layout(size);
    const auto count = [](int length) {
        return std::max((length - 2 * margin + side - 1) / side, 1);
    };
    layout.tiles = {count(size.width), count(size.height)};
    return layout;
}

SampleLayout SampleLayout::without_tiles() const {
    SampleLayout layout = *this;
    layout.tiles = {0, 0};
    return layout;
}

SampleLayout SampleLayout::without_points() const {
    SampleLayout layout = *this;
    layout.cells = layout.points = {0, 0};
    return layout;
}

glm::ivec2 SampleLayout::origin(int tile) const {
    return {origin_of(tile % tiles.width, tiles.width, picture.width),
            origin_of(tile / tiles.width, tiles.height, picture.height)};
}

glm::dvec2 SampleLayout::cell_centre(int cell) const {
    return (glm::dvec2(cell % cells.width, cell / cells.width) + 0.5 +
            static_cast<double>(border)) *
           static_cast<double>(cell_side);
}

glm::dvec2 SampleLayout::point(int index) const {
    return cell_centre(2 * (index / points.width) * cells.width + 2 * (index % points.width));
}

int SampleLayout::quarter_of_point(int index) const {
    const glm::dvec2 share = point(index) / glm::dvec2(picture.width, picture.height);
    const int x = std::min(static_cast<int>(share.x * quarters.width), quarters.width - 1);
    const int y = std::min(static_cast<int>(share.y * quarters.height), quarters.height - 1);
    return 4 * (y / 2 * quarters.width / 2 + x / 2) + y % 2 * 2 + x % 2;
}
