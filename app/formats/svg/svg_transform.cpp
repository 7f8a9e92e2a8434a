#include "formats/svg/svg_transform.h"

#include "base/text.h"
#include "formats/svg/svg_path.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

SvgTransform SvgTransform::operator*(const SvgTransform& inner) const {
    return {a * inner.a + c * inner.b,     b * inner.a + d * inner.b,
            a * inner.c + c * inner.d,     b * inner.c + d * inner.d,
            a * inner.e + c * inner.f + e, b * inner.e + d * inner.f + f};
}

ScenePoint SvgTransform::operator()(const ScenePoint& point) const {
    return {a * point.x + c * point.y + e, b * point.x + d * point.y + f, point.z, point.current};
}

namespace {
SvgTransform rotation(double degrees) {
    const double c = std::cos(degrees * std::numbers::pi / 180.0);
    const double s = std::sin(degrees * std::numbers::pi / 180.0);
    return {c, s, -s, c, 0, 0};
}

double tangent(double degrees) {
    return std::tan(degrees * std::numbers::pi / 180.0);
}

std::optional<SvgTransform> single_transform(std::string_view name,
                                             const std::vector<double>& numbers) {
    const auto count = numbers.size();
    if (name == "matrix" && count == 6)
        return SvgTransform{numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]};
    if (name == "translate" && (count == 1 || count == 2))
        return SvgTransform{1, 0, 0, 1, numbers[0], count == 2 ? numbers[1] : 0};
    if (name == "scale" && (count == 1 || count == 2))
        return SvgTransform{numbers[0], 0, 0, numbers[count - 1], 0, 0};
    if (name == "rotate" && count == 1)
        return rotation(numbers[0]);
    if (name == "rotate" && count == 3)
        return SvgTransform{1, 0, 0, 1, numbers[1], numbers[2]} * rotation(numbers[0]) *
               SvgTransform{1, 0, 0, 1, -numbers[1], -numbers[2]};
    if (name == "skewX" && count == 1)
        return SvgTransform{1, 0, tangent(numbers[0]), 1, 0, 0};
    if (name == "skewY" && count == 1)
        return SvgTransform{1, tangent(numbers[0]), 0, 1, 0, 0};
    return std::nullopt;
}
}  // namespace

Result<SvgTransform> parse_svg_transform(std::string_view text) {
    SvgTransform whole;
    for (std::string_view rest = trim(text); !rest.empty();) {
        const std::size_t open = rest.find('(');
        const std::size_t close = rest.find(')');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open)
            return fail({{}, 0, "expected a transform such as translate(10 20)"});
        const auto numbers = parse_svg_numbers(rest.substr(open + 1, close - open - 1));
        const std::string_view name = trim(rest.substr(0, open));
        const auto single = numbers ? single_transform(name, *numbers) : std::nullopt;
        if (!single)
            return fail(
                {{}, 0, fmt::format("unknown transform '{}' or wrong number of arguments", name)});
        whole = whole * *single;
        rest.remove_prefix(close + 1);
        while (!rest.empty() && (rest.front() == ',' || trim(rest.substr(0, 1)).empty()))
            rest.remove_prefix(1);
    }
    return whole;
}
