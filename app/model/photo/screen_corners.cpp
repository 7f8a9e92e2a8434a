#include "model/photo/screen_corners.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {
constexpr int most_across = 320;

// A small photo: one value for each block of px, 0..1.
struct SmallPhoto {
    int block = 1;  // px
    Extent extent;
    std::vector<float> values;

    // Across and down, or the reverse if turned. It is dark outside the photo.
    float at(int x, int y, bool is_turned) const {
        if (x < 0 || x >= (is_turned ? extent.height : extent.width))
            return 0.0F;
        const auto row = static_cast<std::size_t>(is_turned ? x : y);
        const auto column = static_cast<std::size_t>(is_turned ? y : x);
        return values[row * static_cast<std::size_t>(extent.width) + column];
    }
};

SmallPhoto reduced(const Picture& photo) {
    SmallPhoto small;
    small.block = std::max((photo.extent.width + most_across - 1) / most_across, 1);
    small.extent = {photo.extent.width / small.block, photo.extent.height / small.block};
    for (int y = 0; y < small.extent.height; ++y)
        for (int x = 0; x < small.extent.width; ++x) {
            float sum = 0.0F;
            for (int row = 0; row < small.block; ++row)
                for (int column = 0; column < small.block; ++column) {
                    const float* rgb =
                        &photo.pixels[photo.index(x * small.block + column, y * small.block + row)];
                    sum += std::max({rgb[0], rgb[1], rgb[2]});
                }
            small.values.push_back(sum / static_cast<float>(small.block * small.block));
        }
    return small;
}

// A nearly vertical line, or horizontal if the photo is turned: x at the first and last row.
struct Edge {
    double first = 0.0;
    double last = 0.0;

    double at(double share) const { return first + share * (last - first); }
};

constexpr int distance = 2;  // px at which both sides of an edge are compared

// How much lighter the inside is, over the middle of the edge, because glass may be curved. Single
// spots count little.
double contrast(const SmallPhoto& photo, bool is_turned, Edge edge, int inside) {
    constexpr float most = 0.2F;
    const int rows = is_turned ? photo.extent.width : photo.extent.height;
    const int columns = is_turned ? photo.extent.height : photo.extent.width;
    double sum = 0.0;
    int count = 0;
    for (int y = 3 * rows / 10; y < rows - 3 * rows / 10; ++y, ++count) {
        const auto x = static_cast<int>(std::lround(edge.at(y / (rows - 1.0))));
        const int within = x + inside * distance;
        const int without = x - inside * distance;
        if (within < 0 || within >= columns)
            return 0.0;
        sum += static_cast<double>(std::clamp(
            photo.at(within, y, is_turned) - photo.at(without, y, is_turned), -most, most));
    }
    return sum / std::max(count, 1);
}

// The outermost of the strong edges in a half of the photo. `inside`: 1 for the first half.
std::optional<Edge> find_edge(const SmallPhoto& photo, bool is_turned, int inside) {
    constexpr double least = 0.03;
    constexpr double strong = 0.6;  // of the strongest
    constexpr double equal = 0.999;
    const int columns = is_turned ? photo.extent.height : photo.extent.width;
    const int rows = is_turned ? photo.extent.width : photo.extent.height;
    const int lean = rows / 6;
    std::optional<Edge> outermost;
    Edge end;             // the last that is as strong: an edge has several px of equal contrast
    double best = least;  // at the position of `outermost`
    double strongest = least;
    for (int x = columns / 2 - 1; x >= -distance; --x) {
        Edge local;
        double here = 0.0;
        for (int i = 0; i <= 2 * lean; ++i) {  // from straight to slanted
            const int slope = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
            const double middle = inside > 0 ? x : columns - 1 - x;
            const Edge edge{middle - 0.5 * slope, middle + 0.5 * slope};
            if (const double found = contrast(photo, is_turned, edge, inside); found > here) {
                here = found;
                local = edge;
            }
        }
        strongest = std::max(strongest, here);
        constexpr int near = 4;  // the same edge, seen from px further outside
        const bool is_same = outermost && std::abs(outermost->at(0.5) - local.at(0.5)) <= near;
        if (here > strong * strongest && (!is_same || here > best)) {
            best = here;
            outermost = end = local;
        } else if (is_same && here > equal * best) {
            end = local;
        }
    }
    if (outermost)
        *outermost = {(outermost->first + end.first) / 2.0, (outermost->last + end.last) / 2.0};
    return outermost;
}

// The crossing of a nearly horizontal and a nearly vertical line.
glm::dvec2 crossing(Edge across, Edge down, Extent extent) {
    const double height = extent.height - 1.0;
    const double width = extent.width - 1.0;
    const double down_slope = (down.last - down.first) / height;
    const double across_slope = (across.last - across.first) / width;
    const double x = (down.first + down_slope * across.first) / (1.0 - down_slope * across_slope);
    return {x, across.first + across_slope * x};
}
}  // namespace

std::optional<Corners> guess_corners(const Picture& photo) {
    const SmallPhoto small = reduced(photo);
    constexpr int least_side = 24;
    if (small.extent.width < least_side || small.extent.height < least_side)
        return std::nullopt;
    const auto left = find_edge(small, false, 1);
    const auto right = find_edge(small, false, -1);
    const auto top = find_edge(small, true, 1);
    const auto bottom = find_edge(small, true, -1);
    if (!left || !right || !top || !bottom)
        return std::nullopt;
    Corners corners{crossing(*top, *left, small.extent), crossing(*top, *right, small.extent),
                    crossing(*bottom, *right, small.extent),
                    crossing(*bottom, *left, small.extent)};
    const glm::dvec2 last(photo.extent.width, photo.extent.height);
    for (glm::dvec2& corner : corners)
        corner =
            glm::clamp((corner + 0.5) * static_cast<double>(small.block), glm::dvec2(0.0), last);
    const double near = 0.02 * photo.extent.width;
    const bool are_those_of_the_photo = std::ranges::equal(
        corners, corners_of(photo.extent),
        [near](glm::dvec2 some, glm::dvec2 other) { return glm::distance(some, other) < near; });
    if (are_those_of_the_photo || !check_corners(corners, photo.extent))
        return std::nullopt;
    return corners;
}
