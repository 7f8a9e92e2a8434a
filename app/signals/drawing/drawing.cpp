#include "signals/drawing/drawing.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {
constexpr double farthest = 100.0;

std::string text_of(const Stroke& stroke) {
    std::string text(1, stroke.is_smooth ? 'S' : 'L');
    for (std::size_t i = 0; i < stroke.points.size(); ++i)
        text += fmt::format("{}{} {}", i > 0 ? " " : "",
                            format_number(kept_coordinate(stroke.points[i][0])),
                            format_number(kept_coordinate(stroke.points[i][1])));
    return text + (stroke.is_closed ? "z" : "");
}

// Parses numbers separated by single spaces, each within the limit. Empty on error.
std::vector<double> numbers_in(std::string_view text) {
    std::vector<double> numbers;
    for (const std::string_view piece : split(text, ' ')) {
        const auto number = parse_number(piece);
        if (!number || std::abs(*number) > farthest)
            return {};
        numbers.push_back(*number);
    }
    return numbers;
}

Result<Stroke> stroke_in(std::string_view text) {
    Stroke stroke;
    const char kind = text.empty() ? '\0' : text.front();
    if (kind != 'L' && kind != 'S')
        return fail({{}, 0, "expected L for lines or S for a smooth curve first"});
    stroke.is_smooth = kind == 'S';
    text.remove_prefix(1);
    stroke.is_closed = text.ends_with('z');
    if (stroke.is_closed)
        text.remove_suffix(1);
    const std::vector<double> numbers = numbers_in(text);
    if (numbers.empty() || numbers.size() % 2 != 0)
        return fail({{}, 0, "expected pairs of numbers from -100 to 100, as in L0 0 0.5 0.5"});
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        stroke.points.push_back({numbers[i], numbers[i + 1]});
    return stroke;
}

Result<Keyframe> keyframe_in(std::string_view text, std::size_t number) {
    Keyframe keyframe;
    if (text.empty())
        return keyframe;
    for (const std::string_view piece : split(text, ';')) {
        auto stroke = stroke_in(piece);
        if (!stroke)
            return fail({{},
                         0,
                         fmt::format("stroke {} of keyframe {}: {}", keyframe.size() + 1, number,
                                     stroke.error().front().message)});
        keyframe.push_back(std::move(*stroke));
    }
    return keyframe;
}

template <class Visit>
void for_each_point(Drawing& drawing, const Visit& visit) {
    for (Keyframe& keyframe : drawing.keyframes)
        for (Stroke& stroke : keyframe)
            for (BeamPosition& point : stroke.points)
                visit(point);
}
}  // namespace

std::size_t point_count(const Drawing& drawing) {
    std::size_t count = 0;
    for (const Keyframe& keyframe : drawing.keyframes)
        for (const Stroke& stroke : keyframe)
            count += stroke.points.size();
    return count;
}

bool has_strokes(const Drawing& drawing) {
    return point_count(drawing) > 0;
}

Drawing to_scale(const Drawing& drawing, double side) {
    constexpr double far = std::numeric_limits<double>::max();
    Drawing scaled = drawing;
    if (drawing.is_to_scale || !has_strokes(drawing))
        return scaled;
    BeamPosition low{far, far};
    BeamPosition high{-far, -far};
    for_each_point(scaled, [&](const BeamPosition& point) {
        low = {std::min(low[0], point[0]), std::min(low[1], point[1])};
        high = {std::max(high[0], point[0]), std::max(high[1], point[1])};
    });
    const double longer = std::max(high[0] - low[0], high[1] - low[1]);
    const double factor = longer > 0.0 ? side / longer : 1.0;
    for_each_point(scaled, [&](BeamPosition& point) {
        point = {factor * (point[0] - 0.5 * (low[0] + high[0])),
                 factor * (point[1] - 0.5 * (low[1] + high[1]))};
    });
    scaled.is_to_scale = true;
    return scaled;
}

double kept_coordinate(double value) {
    return std::round(value * 1e4) / 1e4 + 0.0;  // + 0 avoids -0
}

std::string to_text(const Drawing& drawing) {
    std::string text;
    for (const Keyframe& keyframe : drawing.keyframes) {
        text += '[';
        for (std::size_t i = 0; i < keyframe.size(); ++i)
            text += (i > 0 ? ";" : "") + text_of(keyframe[i]);
        text += ']';
    }
    return text;
}

Result<Drawing> parse_drawing(std::string_view text) {
    Drawing drawing;
    while (!text.empty()) {
        const std::size_t end = text.find(']');
        if (text.front() != '[' || end == std::string_view::npos)
            return fail({{}, 0, "each keyframe must be enclosed in [ and ]"});
        auto keyframe = keyframe_in(text.substr(1, end - 1), drawing.keyframes.size() + 1);
        if (!keyframe)
            return fail(keyframe.error());
        drawing.keyframes.push_back(std::move(*keyframe));
        text.remove_prefix(end + 1);
    }
    if (drawing.keyframes.empty())
        return fail({{}, 0, "expected at least one keyframe, such as the empty one []"});
    if (drawing.keyframes.size() > max_keyframes)
        return fail({{}, 0, fmt::format("too many keyframes; the limit is {}", max_keyframes)});
    if (point_count(drawing) > max_drawing_points)
        return fail({{}, 0, fmt::format("too many points; the limit is {}", max_drawing_points)});
    return drawing;
}
