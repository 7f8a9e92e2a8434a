#include "model/plan/lead_in.h"

#include "model/plan/expression.h"
#include "model/plan/numbers.h"
#include "model/plan/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>

namespace {
// Whether earlier frames of the pass affect it without end.
bool has_endless_history(const Look& look, std::size_t pass) {
    return std::ranges::any_of(look.passes[pass].inputs, [&](const Input& input) {
        const auto read = find_pass(look, input.name);
        return input.from == Input::From::pass && read && dependencies_of(look, *read)[pass];
    });
}

// How many frames back the picture depends on, without endless histories: at most the sum over all
// passes, as each can read another one.
std::int64_t depth_of(const Look& look) {
    std::int64_t depth = 0;
    for (const Pass& pass : look.passes) {
        std::int64_t deepest = 0;
        for (const Input& input : pass.inputs)
            deepest = std::max<std::int64_t>(deepest, input.frames_ago);
        depth += deepest;
    }
    return depth;
}

// The parameters in an expression.
std::set<std::string> names_in(const std::string& expression) {
    std::set<std::string> names;
    const auto is_letter = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    for (std::size_t at = expression.find('$'); at != std::string::npos;
         at = expression.find('$', at + 1)) {
        const auto begin = expression.begin() + static_cast<std::ptrdiff_t>(at) + 1;
        names.emplace(begin, std::find_if_not(begin, expression.end(), is_letter));
    }
    return names;
}

/// The two expressions at some values; not finite: nothing fades.
struct Numbers {
    double time_constant = 0.0;
    double peak = 0.0;
};

Result<double> evaluated(const Look& look, const char* key, const std::string& expression,
                         const std::map<std::string, double>& names) {
    const auto finite = evaluate(fmt::format("finite({})", expression), names);
    if (!finite)
        return fail({look.fading->declared.file, look.fading->declared.line,
                     fmt::format("'{}' of 'fading': {}", key, finite.error().front().message)});
    return evaluate(expression, names).value_or(std::numeric_limits<double>::infinity());
}

Result<Numbers> numbers_at(const Look& look, const Values& values, double fps) {
    auto names = numbers_of(look, values);
    names["FPS"] = fps;
    const auto constant = evaluated(look, "time_constant", look.fading->time_constant, names);
    if (!constant)
        return fail(constant.error());
    const auto peak = evaluated(look, "peak", look.fading->peak, names);
    if (!peak)
        return fail(peak.error());
    return Numbers{std::max(0.0, *constant), *peak};
}

double seconds_of(const Numbers& numbers) {
    constexpr double half_step = 0.5 / 255.0;
    constexpr double steepest_encoding = 12.92;
    return numbers.time_constant *
           std::log(std::max(1.0, numbers.peak * steepest_encoding / half_step));
}

std::optional<std::string> moving_name(const Fading& fading, const std::set<std::string>& moving) {
    for (const std::string* expression : {&fading.time_constant, &fading.peak})
        for (const std::string& name : names_in(*expression))
            if (moving.contains(name))
                return name;
    return std::nullopt;
}
}  // namespace

LeadIn lead_in_of(const Look& look, const Values& values, double fps, int subframes,
                  const std::set<std::string>& moving) {
    const auto accumulates = std::ranges::find(look.passes, true, &Pass::accumulate);
    if (accumulates != look.passes.end())
        return {.reason = fmt::format("pass '{}' accumulates", accumulates->name)};
    const std::int64_t depth = depth_of(look) * subframes;
    bool is_endless = false;
    for (std::size_t pass = 0; pass < look.passes.size(); ++pass)
        is_endless = is_endless || has_endless_history(look, pass);
    if (!is_endless)
        return {.frames = depth};
    if (!look.fading)
        return {.reason = fmt::format("how the earlier frames of '{}' fade is not known", look.id)};
    if (const auto name = moving_name(*look.fading, moving))
        return {.reason = fmt::format("'{}' changes over time, and the fading of earlier frames "
                                      "depends on it",
                                      *name)};
    const auto numbers = numbers_at(look, values, fps);
    if (!numbers)
        return {.reason = numbers.error().front().message};
    const double seconds = seconds_of(*numbers);
    if (!std::isfinite(seconds))
        return {.reason = "at these values, earlier frames do not fade"};
    constexpr double longest = 86400.0;
    if (seconds > longest)
        return {.reason = "earlier frames fade over more than a day"};
    return {.frames = static_cast<std::int64_t>(std::ceil(seconds * fps)) + depth};
}

Diagnostics check_fading(const Look& look) {
    constexpr double usual_fps = 60.0;
    if (!look.fading)
        return {};
    const auto numbers = numbers_at(look, {}, usual_fps);
    return numbers ? Diagnostics() : numbers.error();
}
