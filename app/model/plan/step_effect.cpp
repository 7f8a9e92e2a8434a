#include "model/plan/step_effect.h"

#include "model/plan/parameter_use.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace {
constexpr double levels = 255.0;
constexpr double min_shown_share = 1e-4;

// Whether `reader` reads the output of `pass`, in this frame or a later one.
bool reads(const Look& look, std::size_t reader, std::size_t pass) {
    return std::ranges::any_of(look.passes[reader].inputs, [&](const Input& input) {
        return input.from == Input::From::pass && input.name == look.passes[pass].name;
    });
}

// Whether a pass draws the same although it uses the parameter or reads a changed pass.
bool ends_in(const Look& look, std::size_t pass, const Parameter& parameter,
             const std::vector<PassChange>& changes) {
    if (changes[pass].has_changed())
        return false;
    if (is_used_by(look, pass, parameter))
        return true;
    for (std::size_t other = 0; other < changes.size(); ++other)
        if (changes[other].has_changed() && reads(look, pass, other))
            return true;
    return false;
}

std::string quoted(const std::vector<std::string>& names) {
    std::vector<std::string> quoted;
    for (const std::string& name : names)
        quoted.push_back('"' + name + '"');
    return fmt::format("{}", fmt::join(quoted, ", "));
}

std::string levels_text(double share) {
    const double count = share * levels;
    return count < 0.95 ? fmt::format("{:.2g}", count) : fmt::format("{:.0f}", count);
}
}  // namespace

double change_share(const PassChange& change) {
    if (!(change.mean > 0.0))
        return 0.0;
    if (!(change.level > change.mean) || !std::isfinite(change.mean))
        return 1.0;
    return change.mean / change.level;
}

double change_ratio(const PassChange& change) {
    const double share = change_share(change);
    if (share <= 0.0)
        return 0.0;
    constexpr double min_seen = 0.02;  // of the bar, for any change
    const double position = 1.0 - std::log(share) / std::log(min_shown_share);
    return std::clamp(position, min_seen, 1.0);
}

StepEffect effect_of(const Look& look, const Parameter& parameter,
                     const std::vector<PassChange>& changes) {
    StepEffect effect;
    for (std::size_t pass = 0; pass < changes.size(); ++pass)
        if (changes[pass].has_changed())
            effect.last_changed = look.passes[pass].name;
    const PassChange& picture = changes.back();
    if (picture.has_changed()) {
        constexpr double half_a_level = 0.5 / levels;
        effect.kind =
            picture.largest < half_a_level ? StepEffect::Kind::faint : StepEffect::Kind::seen;
        return effect;
    }
    effect.kind = effect.last_changed.empty() ? StepEffect::Kind::none : StepEffect::Kind::lost;
    for (std::size_t pass = 0; pass < changes.size(); ++pass)
        if (ends_in(look, pass, parameter, changes))
            effect.ends.push_back(look.passes[pass].name);
    return effect;
}

std::string effect_text(const StepEffect& effect, const PassChange& picture) {
    if (effect.kind == StepEffect::Kind::seen)
        return fmt::format("changes the picture by up to {} of 255 levels, {} on average",
                           levels_text(picture.largest), levels_text(picture.mean));
    if (effect.kind == StepEffect::Kind::faint)
        return fmt::format("too small to see: at most {} of 255 levels",
                           levels_text(picture.largest));
    const std::string ends = quoted(effect.ends);
    if (effect.kind == StepEffect::Kind::lost && ends.empty())
        return fmt::format("doesn't change the picture: no pass reads \"{}\"", effect.last_changed);
    if (effect.kind == StepEffect::Kind::lost)
        return fmt::format("doesn't change the picture: its effect ends in {}", ends);
    if (ends.empty())
        return "has no effect: no pass uses it";
    return fmt::format("has no effect: the output of {} stays the same", ends);
}
