#include "signals/drawing/shapes.h"

#include "model/look/color.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>

namespace {
ScenePoint on_circle(double radius, double degrees) {
    const double radians = degrees * std::numbers::pi / 180.0;
    return {radius * std::cos(radians), radius * std::sin(radians)};
}

// The mean luminance (ITU-R BT.709) of the picture's box (x0, y0) .. (x1, y1) in px.
double light_of(const Picture& picture, int x0, int x1, int y0, int y1) {
    const double weights[3] = {0.2126, 0.7152, 0.0722};
    const bool is_grey = picture.channels < 3;
    double sum = 0.0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            for (std::size_t channel = 0; channel < (is_grey ? 1 : 3); ++channel) {
                auto value = static_cast<double>(picture.pixels[picture.index(x, y) + channel]);
                if (!std::isfinite(value))
                    value = 0.0;
                const double light =
                    picture.encoding == Encoding::display ? srgb_decode(value) : value;
                sum += light * (is_grey ? 1.0 : weights[channel]);
            }
    return std::clamp(sum / (static_cast<double>(x1 - x0) * (y1 - y0)), 0.0, 16.0);
}

// Box `index` of `count` along `length` px: its first pixel, and one past its last.
std::array<int, 2> box(int index, int count, int length) {
    const int first = static_cast<int>(static_cast<std::int64_t>(index) * length / count);
    const int end = static_cast<int>(static_cast<std::int64_t>(index + 1) * length / count);
    const int begin = std::min(first, length - 1);
    return {begin, std::max(end, begin + 1)};
}
}  // namespace

ScenePath arc_path(double radius, double from_degrees, double to_degrees) {
    constexpr double degrees_per_step = 3.0;
    const int steps = std::max(
        1, static_cast<int>(std::ceil(std::abs(to_degrees - from_degrees) / degrees_per_step)));
    ScenePath path{{}, true};
    for (int i = 0; i <= steps; ++i)
        path.points.push_back(
            on_circle(radius, std::lerp(from_degrees, to_degrees, static_cast<double>(i) / steps)));
    return path;
}

std::vector<ScenePath> polygon_paths(double radius, int sides, int skip) {
    std::vector<ScenePath> paths;
    const int rounds = std::gcd(sides, skip);
    for (int round = 0; round < rounds; ++round) {
        ScenePath path;
        for (int i = 0; i <= sides / rounds; ++i)
            path.points.push_back(on_circle(radius, 90.0 + 360.0 * (round + i * skip) / sides));
        paths.push_back(std::move(path));
    }
    return paths;
}

std::vector<ScenePath> grid_paths(double width, double height, int columns, int rows) {
    std::vector<ScenePath> paths;
    // Every other line is reversed to shorten the moves between lines.
    const auto add = [&paths](ScenePoint from, ScenePoint to, bool is_backwards) {
        if (is_backwards)
            std::swap(from, to);
        paths.push_back({{from, to}});
    };
    for (int i = 0; i <= columns; ++i) {
        const double x = width * (static_cast<double>(i) / columns - 0.5);
        add({x, -0.5 * height}, {x, 0.5 * height}, i % 2 == 1);
    }
    for (int i = 0; i <= rows; ++i) {
        const double y = height * (static_cast<double>(i) / rows - 0.5);
        add({-0.5 * width, y}, {0.5 * width, y}, i % 2 == 1);
    }
    return paths;
}

std::vector<ScenePath> raster_paths(const Picture& picture, double height, int lines) {
    const double shape = static_cast<double>(picture.extent.width) / picture.extent.height;
    const double width = height * shape;
    const int columns = std::clamp(static_cast<int>(lines * shape), 1, 1024);
    std::vector<ScenePath> paths;
    for (int line = 0; line < lines; ++line) {
        const double y = height * (0.5 - (line + 0.5) / lines);
        const auto rows = box(line, lines, picture.extent.height);
        ScenePath path{{{-0.5 * width, y, 0.0, 0.0}}, true};
        for (int i = 0; i < columns; ++i) {
            const auto span = box(i, columns, picture.extent.width);
            const double x = width * ((i + 1.0) / columns - 0.5);
            path.points.push_back(
                {x, y, 0.0, light_of(picture, span[0], span[1], rows[0], rows[1])});
        }
        paths.push_back(std::move(path));
    }
    return paths;
}

std::vector<ScenePath> fitted_paths(std::vector<ScenePath> paths, double side) {
    constexpr double far = std::numeric_limits<double>::max();
    std::array<double, 3> low{far, far, far};
    std::array<double, 3> high{-far, -far, -far};
    for (const ScenePath& path : paths)
        for (const ScenePoint& point : path.points) {
            low = {std::min(low[0], point.x), std::min(low[1], point.y), std::min(low[2], point.z)};
            high = {std::max(high[0], point.x), std::max(high[1], point.y),
                    std::max(high[2], point.z)};
        }
    const double widest = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    const double scale = widest > 0.0 ? side / widest : 1.0;
    for (ScenePath& path : paths)
        for (ScenePoint& point : path.points)
            point = {scale * (point.x - 0.5 * (low[0] + high[0])),
                     scale * (point.y - 0.5 * (low[1] + high[1])),
                     scale * (point.z - 0.5 * (low[2] + high[2])), point.current};
    return paths;
}

std::vector<ScenePath> edge_paths(const std::vector<ScenePoint>& corners,
                                  const std::vector<std::array<std::size_t, 2>>& edges) {
    std::vector<std::vector<std::size_t>> edges_at(corners.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (const std::size_t corner : edges[i])
            edges_at[corner].push_back(i);
    std::vector<bool> is_drawn(edges.size(), false);
    std::vector<ScenePath> paths;
    // A path from the first open edge may end before it has covered that edge.
    for (std::size_t first = 0; first < edges.size();) {
        if (is_drawn[first]) {
            ++first;
            continue;
        }
        std::size_t here = edges[first][0];
        ScenePath path{{corners[here]}};
        for (;;) {
            auto& open = edges_at[here];
            while (!open.empty() && is_drawn[open.back()])
                open.pop_back();
            if (open.empty())
                break;
            const auto& edge = edges[open.back()];
            is_drawn[open.back()] = true;
            here = edge[0] == here ? edge[1] : edge[0];
            path.points.push_back(corners[here]);
        }
        paths.push_back(std::move(path));
    }
    return paths;
}
