#include "model/photo/beam_places.h"

#include "model/photo/pixel_index.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr double small_reach = 24.0;  // px of the reduced photo

// The mean light of blocks of px, and whether one of them is overexposed.
struct Blocks {
    int side = 1;  // px
    LightMap map;
    std::vector<bool> is_clipped;
};

Blocks reduced(const Picture& photo, const LightMap& map, int side) {
    constexpr float highest = 254.0F / 255.0F;
    Blocks blocks{side, {{map.extent.width / side, map.extent.height / side}, {}}, {}};
    for (int y = 0; y < blocks.map.extent.height; ++y)
        for (int x = 0; x < blocks.map.extent.width; ++x) {
            float sum = 0.0F;
            bool is_clipped = false;
            for (int row = y * side; row < (y + 1) * side; ++row)
                for (int column = x * side; column < (x + 1) * side; ++column) {
                    sum += map.light[pixel_index(map.extent, column, row)];
                    const float* rgb = &photo.pixels[photo.index(column, row)];
                    is_clipped = is_clipped || std::max({rgb[0], rgb[1], rgb[2]}) >= highest;
                }
            blocks.map.light.push_back(sum / static_cast<float>(side * side));
            blocks.is_clipped.push_back(is_clipped);
        }
    return blocks;
}

// The shape of the light around a position: moments of what is brighter than a tenth.
struct Shape {
    glm::dvec2 middle{0.0};  // from the position
    double wide = 0.0;       // variance along the longer axis, px^2
    double narrow = 0.0;
    glm::dvec2 along{1.0, 0.0};
    bool is_clipped = false;
};

class BeamSearch {
public:
    BeamSearch(const Blocks& blocks, const Corners& corners, double reach)
        : m_blocks(blocks), m_reach(reach) {
        for (std::size_t i = 0; i < corners.size(); ++i)
            m_corners[i] = corners[i] / static_cast<double>(blocks.side);
        for (int y = 0; y < blocks.map.extent.height; ++y)
            for (int x = 0; x < blocks.map.extent.width; ++x)
                if (is_inside(glm::dvec2(x, y) + 0.5))
                    m_most = std::max(m_most, light(x, y));
    }

    BeamPlaces run() {
        constexpr float bright = 0.3F;  // of the most
        for (int y = 0; y < m_blocks.map.extent.height; ++y)
            for (int x = 0; x < m_blocks.map.extent.width; ++x)
                if (light(x, y) > bright * m_most && is_inside(glm::dvec2(x, y) + 0.5))
                    consider(x, y);
        return {place_of(m_line, true), place_of(m_dot, false), m_has_clipped};
    }

private:
    struct Found {
        glm::dvec2 at;
        Shape shape;
        double merit = 0.0;
    };

    float light(int x, int y) const {
        return m_blocks.map.light[pixel_index(m_blocks.map.extent, x, y)];
    }

    // At least the reach from all sides of the screen, whose corners are clockwise.
    bool is_inside(glm::dvec2 at) const {
        for (std::size_t i = 0; i < 4; ++i) {
            const glm::dvec2 side = glm::normalize(m_corners[(i + 1) % 4] - m_corners[i]);
            const glm::dvec2 from = at - m_corners[i];
            if (side.x * from.y - side.y * from.x < m_reach)
                return false;
        }
        return true;
    }

    void consider(int x, int y) {
        const Shape shape = shape_around(x, y);
        const double disc = 0.25 * m_reach * m_reach;  // variance of an even disc
        if (glm::length(shape.middle) > 0.1 * m_reach || shape.narrow > 0.15 * disc ||
            !is_on_ridge(x, y, shape))
            return;
        const bool is_line = shape.wide > 0.8 * disc;
        const bool is_dot = shape.wide < 0.15 * disc && shape.wide < 1.5 * shape.narrow;
        if (!is_line && !is_dot)
            return;
        if (shape.is_clipped) {
            m_has_clipped = true;
            return;
        }
        const Found found{glm::dvec2(x, y) + 0.5, shape,
                          is_line ? -shape.narrow : static_cast<double>(light(x, y))};
        std::optional<Found>& best = is_line ? m_line : m_dot;
        if (!best || found.merit > best->merit)
            best = found;
    }

    // Whether the position is on the ridge of a line or dot whose middle is there too. A bent line
    // has its middle at some distance from its ridge.
    bool is_on_ridge(int x, int y, const Shape& shape) const {
        const glm::dvec2 across(-shape.along.y, shape.along.x);
        const glm::dvec2 here = glm::dvec2(x, y) + 0.5;
        std::vector<double> distances;
        std::vector<float> seen;
        for (double distance = -0.3 * m_reach; distance < 0.3 * m_reach; distance += 0.25) {
            distances.push_back(distance);
            seen.push_back(m_blocks.map.at(here + distance * across));
        }
        const float high = 0.98F * std::ranges::max(seen);
        double sum = 0.0;
        int count = 0;
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (seen[i] >= high) {
                sum += distances[i];
                ++count;
            }
        const double ridge = sum / count;
        return std::abs(ridge) < 1.0 &&
               std::abs(glm::dot(shape.middle, across) - ridge) < 0.05 * m_reach;
    }

    Shape shape_around(int x, int y) const {
        const int reach = static_cast<int>(m_reach);
        float low = light(x, y);
        float high = low;
        Shape shape;
        const auto for_each = [&](auto use) {
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx)
                    if (dx * dx + dy * dy <= reach * reach && is_in_photo(x + dx, y + dy))
                        use(dx, dy);
        };
        for_each([&](int dx, int dy) {
            low = std::min(low, light(x + dx, y + dy));
            high = std::max(high, light(x + dx, y + dy));
            shape.is_clipped = shape.is_clipped || is_clipped(x + dx, y + dy);
        });
        const float threshold = low + 0.1F * (high - low);
        double sum = 0.0;
        glm::dvec2 mean(0.0);
        glm::dmat2 square(0.0);
        for_each([&](int dx, int dy) {
            const double weight =
                std::max(static_cast<double>(light(x + dx, y + dy) - threshold), 0.0);
            const glm::dvec2 from(dx, dy);
            sum += weight;
            mean += weight * from;
            square += weight * glm::outerProduct(from, from);
        });
        shape.middle = mean / std::max(sum, 1e-12);
        set_axes(square / std::max(sum, 1e-12) - glm::outerProduct(shape.middle, shape.middle),
                 shape);
        return shape;
    }

    // The eigenvalues and the first eigenvector of a symmetric matrix.
    static void set_axes(const glm::dmat2& square, Shape& shape) {
        const double half_sum = 0.5 * (square[0][0] + square[1][1]);
        const double half_difference = 0.5 * (square[0][0] - square[1][1]);
        const double root = std::hypot(half_difference, square[0][1]);
        const double angle = 0.5 * std::atan2(square[0][1], half_difference);
        shape.wide = half_sum + root;
        shape.narrow = half_sum - root;
        shape.along = {std::cos(angle), std::sin(angle)};
    }

    bool is_in_photo(int x, int y) const {
        return x >= 0 && y >= 0 && x < m_blocks.map.extent.width && y < m_blocks.map.extent.height;
    }
    bool is_clipped(int x, int y) const {
        return m_blocks.is_clipped[pixel_index(m_blocks.map.extent, x, y)];
    }

    std::optional<BeamPlace> place_of(const std::optional<Found>& found, bool is_line) const {
        if (!found)
            return std::nullopt;
        return BeamPlace{(found->at + found->shape.middle) * static_cast<double>(m_blocks.side),
                         is_line ? found->shape.along : glm::dvec2(0.0)};
    }

    const Blocks& m_blocks;
    Corners m_corners;  // px of the reduced photo
    double m_reach;     // likewise
    float m_most = 0.0F;
    std::optional<Found> m_line;
    std::optional<Found> m_dot;
    bool m_has_clipped = false;
};
}  // namespace

BeamPlaces find_beam_places(const Picture& photo, const LightMap& map, const Corners& corners,
                            double reach) {
    const int side = std::max(static_cast<int>(std::lround(reach / small_reach)), 1);
    const Blocks blocks = reduced(photo, map, side);
    return BeamSearch(blocks, corners, reach / side).run();
}
