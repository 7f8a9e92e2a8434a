#include "lab/menus/scope_graticule.h"

#include "signals/signal/settings.h"
#include "signals/signal_table.h"

#include <algorithm>

namespace {
bool is_over_time(const Spec& signal) {
    const SignalKind* kind = find_kind(signal.kind);
    const auto complete = completed(signal);
    if (!kind || !complete || !find_setting(*kind, "sdiv"))
        return false;
    const Settings settings(*complete);
    return settings.is("mode", "yt") || settings.is("mode", "waveform");
}

// "Keep circles round" would limit the graticule to a square, but 10 x 8 divisions are wider.
const Parameter* fit_to_fill(const Look& look, const Values& values, const std::string& scope) {
    const Parameter* fit = find_parameter(look, scope + "fit");
    const bool is_filled = !fit || value_of(*fit, values).numbers[0] == 0.0;
    return is_filled ? nullptr : fit;
}
}  // namespace

Values scope_graticule(const Look& look, const Values& values, const Spec& signal) {
    Values wanted;
    if (look.passes.empty() || !is_over_time(signal))
        return wanted;
    const std::string& scope = look.passes.front().scope;
    const Parameter* strength = find_parameter(look, scope + "graticule");
    const Parameter* divisions = find_parameter(look, scope + "graticule_divisions");
    if (!divisions || (strength && value_of(*strength, values).numbers[0] == 0.0))
        return wanted;
    const Value tens_by_eights(std::vector<double>{10.0, 8.0});
    if (value_of(*divisions, values) != tens_by_eights)
        wanted[divisions->name] = tens_by_eights;
    if (const Parameter* fit = fit_to_fill(look, values, scope))
        wanted[fit->name] = Value(0.0);
    return wanted;
}
