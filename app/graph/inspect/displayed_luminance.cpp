#include "graph/inspect/displayed_luminance.h"

#include "model/look/color.h"

#include <algorithm>
#include <cmath>

namespace {
using SeenColor = std::array<double, 3>;

double luminance_of(const SeenColor& light) {
    return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];  // ITU-R BT.709
}

// As chosen() of texel_text.h.
SeenColor chosen_of(const std::array<float, 4>& rgba, Channels channels) {
    const SeenColor rgb{rgba[0], rgba[1], rgba[2]};
    if (channels == Channels::color)
        return rgb;
    const double lone = channels == Channels::luminance
                            ? luminance_of(rgb)
                            : rgba[static_cast<std::size_t>(channels) - 1];
    return {lone, lone, lone};
}

bool has(const SeenColor& numbers, bool (*is_so)(double)) {
    return std::ranges::any_of(numbers, is_so);
}

// The colour that replaces one that is not finite or is marked.
std::optional<SeenColor> mark_of(const SeenColor& numbers, const SeenColor& light,
                                 const ViewOptions& options) {
    const bool is_nan = has(numbers, [](double number) { return std::isnan(number); });
    const bool is_infinite = has(numbers, [](double number) { return std::isinf(number); });
    if (options.marks_flaws && is_nan)
        return SeenColor{1, 0, 0};
    if (options.marks_flaws && is_infinite)
        return SeenColor{0, 1, 0};
    if (options.marks_flaws && has(numbers, [](double number) { return number < 0.0; }))
        return SeenColor{0, 0, 1};
    if (options.marks_clipping && has(light, [](double one) { return one >= 1.0; }))
        return SeenColor{1, srgb_decode(0.8), 0};
    if (options.marks_clipping && !has(light, [](double one) { return one > 0.0; }))
        return SeenColor{0, srgb_decode(0.25), srgb_decode(0.3)};
    if (is_nan || is_infinite)
        return SeenColor{1, 0, 1};
    return std::nullopt;
}

// As exposed() of the Viewer.
double exposed_number(double number, const ViewOptions& options, bool is_encoded) {
    const double level =
        (number - options.levels.black) / (options.levels.white - options.levels.black);
    const double gain = std::exp2(options.exposure_stops);
    if (!is_encoded || gain == 1.0)
        return level * gain;
    return std::copysign(srgb_encode(srgb_decode(std::abs(level)) * gain), level);
}

SeenColor decoded(const SeenColor& display) {
    return {srgb_decode(display[0]), srgb_decode(display[1]), srgb_decode(display[2])};
}
}  // namespace

double displayed_luminance(const std::array<float, 4>& rgba, Format format,
                           const ViewOptions& options) {
    const bool is_lone = options.channels == Channels::color && info_of(format).channels == 1;
    const bool is_encoded = options.encoding == Encoding::display && format != Format::srgb8_alpha8;
    const SeenColor numbers = chosen_of(rgba, is_lone ? Channels::red : options.channels);
    SeenColor light;
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = exposed_number(numbers[i], options, is_encoded);
    if (const auto mark = mark_of(numbers, light, options))
        return luminance_of(*mark);
    if (options.is_false_color) {
        const bool has_colors = options.channels == Channels::color && !is_lone;
        const double level = has_colors ? luminance_of(light) : light[0];
        return luminance_of(decoded(false_color(std::clamp(level, 0.0, 1.0))));
    }
    SeenColor display;
    for (std::size_t i = 0; i < light.size(); ++i) {
        const double visible = std::clamp(light[i], 0.0, 1.0);
        display[i] = is_encoded ? visible : srgb_encode(visible);
    }
    constexpr double checker = 0.28;  // mean of the Viewer's two greys
    if (options.is_over_checker && options.channels == Channels::color && !is_lone) {
        const double alpha = std::clamp(static_cast<double>(rgba[3]), 0.0, 1.0);
        for (double& one : display)
            one = checker + (one - checker) * alpha;
    }
    const bool is_grey = options.marks_flaws || options.marks_clipping;
    return is_grey ? srgb_decode(luminance_of(display)) : luminance_of(decoded(display));
}
