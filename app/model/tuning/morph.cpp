#include "model/tuning/morph.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {
constexpr double full_turn = 2.0 * std::numbers::pi;

bool goes_all_round(const Parameter& parameter) {
    constexpr double tolerance = 1e-3;  // ends are written with few digits
    return parameter.control == Control::angle &&
           parameter.range.high - parameter.range.low >= full_turn - tolerance;
}

bool changes_at_half(const Parameter& parameter) {
    return parameter.type.scalar != Scalar::floating || parameter.control == Control::list ||
           parameter.control == Control::event || parameter.control == Control::image ||
           parameter.control == Control::sound;
}

double between(const Parameter& parameter, double from, double to, double share) {
    if (goes_all_round(parameter))
        return from + std::remainder(to - from, full_turn) * share;
    if (parameter.scale == Scale::logarithmic && from > 0.0 && to > 0.0)
        return from * std::pow(to / from, share);
    return from + (to - from) * share;
}

// An angle that leaves its slider on the shorter way enters at the other end.
double within(const Parameter& parameter, double angle) {
    const Range& range = parameter.range;
    if (!goes_all_round(parameter) || (angle >= range.low && angle <= range.high))
        return angle;
    return angle + full_turn * std::ceil((range.low - angle) / full_turn);
}

Value between(const Parameter& parameter, const Value& from, const Value& to, double share) {
    if (changes_at_half(parameter) || from.numbers.size() != to.numbers.size())
        return share < 0.5 ? from : to;
    Value value = from;
    for (std::size_t i = 0; i < value.numbers.size(); ++i)
        value.numbers[i] =
            within(parameter, between(parameter, from.numbers[i], to.numbers[i], share));
    return clamped(parameter, std::move(value));
}
}  // namespace

Value morphed_value(const Parameter& parameter, const Value& from, const Value& to, double share) {
    if (from == to || share >= 1.0)
        return to;
    return between(parameter, from, to, std::max(share, 0.0));
}

Values morphed(const Look& look, const Values& from, const Values& to, double share) {
    if (share >= 1.0)
        return to;
    Values values = from;
    for (const Parameter& parameter : look.parameters) {
        const Value& start = value_of(parameter, from);
        const Value& end = value_of(parameter, to);
        if (start != end)
            values[parameter.name] = between(parameter, start, end, std::max(share, 0.0));
    }
    return values;
}
