#include "model/picture/gain.h"

#include "model/plan/parameter_use.h"

#include <algorithm>
#include <cmath>
#include <limits>

TargetLevel target_level_of(const Statistics& statistics, std::size_t clipped, double ceiling) {
    const std::size_t texels = statistics.finite + statistics.infinite + statistics.not_a_number;
    TargetLevel gain{statistics.maximum, statistics.mean, ceiling, 0.0};
    if (texels > 0)
        gain.clipped = static_cast<double>(clipped) / static_cast<double>(texels);
    return gain;
}

std::optional<double> headroom_stops(const TargetLevel& gain) {
    if (!(gain.peak > 0.0))
        return std::nullopt;
    return std::log2(gain.ceiling / gain.peak);
}

double format_limit(Format format) {
    switch (format) {
        case Format::r8:
        case Format::rg8:
        case Format::rgba8:
        case Format::srgb8_alpha8:
        case Format::rgb10_a2:
            return 1.0;
        case Format::r11f_g11f_b10f:
            return 64512.0;  // of blue, which has the fewest bits: (2 - 2^-5) 2^15
        case Format::r16f:
        case Format::rg16f:
        case Format::rgba16f:
            return 65504.0;  // (2 - 2^-10) 2^15
        case Format::r32f:
        case Format::rg32f:
        case Format::rgba32f:
            return static_cast<double>(std::numeric_limits<float>::max());
        case Format::r8ui:
        case Format::rg8ui:
        case Format::rgba8ui:
            return 255.0;
        case Format::rgb10_a2ui:
            return 1023.0;
        case Format::r16ui:
        case Format::rg16ui:
        case Format::rgba16ui:
            return 65535.0;
        case Format::r32ui:
        case Format::rg32ui:
        case Format::rgba32ui:
            return 4294967295.0;
        case Format::r8i:
        case Format::rg8i:
        case Format::rgba8i:
            return 127.0;
        case Format::r16i:
        case Format::rg16i:
        case Format::rgba16i:
            return 32767.0;
        case Format::r32i:
        case Format::rg32i:
        case Format::rgba32i:
            return 2147483647.0;
    }
    return 1.0;
}

namespace {
// Also with the prefix of a stack: "phosphor/ceiling".
bool is_ceiling(const Parameter& parameter) {
    const std::string& name = parameter.name;
    return name.substr(name.rfind('/') + 1) == "ceiling" && parameter.type.size() == 1;
}

bool keeps_light(const Pass& pass) {
    return std::ranges::any_of(pass.inputs, [&](const Input& input) {
        return input.from == Input::From::pass && input.name == pass.name;
    });
}
}  // namespace

double ceiling_of(const Look& look, std::size_t pass, const Values& values) {
    const double limit = format_limit(look.passes[pass].format);
    for (const Parameter& parameter : look.parameters) {
        if (!is_ceiling(parameter) || !is_used_by(look, pass, parameter))
            continue;
        std::optional<std::size_t> keeper;
        for (std::size_t i = 0; i < look.passes.size(); ++i)
            if (keeps_light(look.passes[i]) && is_used_by(look, i, parameter))
                keeper = i;
        const double ceiling = value_of(parameter, values).number();
        if (ceiling > 0.0 && keeper.value_or(pass) == pass)
            return std::min(ceiling, limit);
    }
    return limit;
}

double clips_from(double ceiling) {
    return ceiling * (1.0 - std::exp2(-11.0));
}

double meter_ratio(double number, double ceiling) {
    if (!(number > 0.0))
        return 0.0;
    return std::clamp(1.0 + std::log2(number / ceiling) / meter_stops, 0.0, 1.0);
}
