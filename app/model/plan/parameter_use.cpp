#include "model/plan/parameter_use.h"

#include <algorithm>
#include <cctype>

namespace {
// Finds "$scale", but not as the start of "$scale_x".
bool reads(const std::string& expression, const std::string& name) {
    const auto goes_on = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    const std::string sought = '$' + name;
    for (auto at = expression.find(sought); at != std::string::npos;
         at = expression.find(sought, at + 1)) {
        const std::size_t end = at + sought.size();
        if (end == expression.size() || !goes_on(expression[end]))
            return true;
    }
    return false;
}

// `name` is relative to the pass's look.
bool follows(const Pass& pass, const std::string& name) {
    return std::ranges::any_of(pass.size, [&](const Side& side) {
        return side.by == Side::By::expression && reads(side.expression, name);
    });
}
}  // namespace

bool drives_size(const Look& look, const Parameter& parameter) {
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        if (affects_target_size(look, i, parameter))
            return true;
    return false;
}

bool affects_target_size(const Look& look, std::size_t pass, const Parameter& parameter) {
    const Pass& user = look.passes[pass];
    const std::string& name = parameter.name;
    if (user.repeat == Count(name) || user.converge == Count(name))
        return true;
    if (!name.starts_with(user.scope))
        return false;
    const std::string own = name.substr(user.scope.size());
    return reads(user.one_channel, own) || follows(user, own);
}

bool is_used_by(const Look& look, std::size_t pass, const Parameter& parameter) {
    const Pass& user = look.passes[pass];
    const std::string& name = parameter.name;
    if (affects_target_size(look, pass, parameter))
        return true;
    if (std::ranges::any_of(parameter.bindings, [&](const Binding& binding) {
            return static_cast<std::size_t>(binding.pass) == pass;
        }))
        return true;
    if (!name.starts_with(user.scope))
        return false;
    const std::string own = name.substr(user.scope.size());
    const bool is_spot = std::ranges::any_of(
        user.spot, [&](const std::string& length) { return reads(length, own); });
    return is_spot || reads(user.half_floats, own) || (user.onto && reads(user.onto->where, own));
}

bool affects_aliasing(const Look& look, const Parameter& parameter) {
    return std::ranges::any_of(look.passes, [&](const Pass& pass) {
        return pass.onto && parameter.name.starts_with(pass.scope) &&
               reads(pass.onto->where, parameter.name.substr(pass.scope.size()));
    });
}

bool is_idle(const Look& look, std::size_t pass, Extent extent) {
    const Pass& sized = look.passes[pass];
    return extent == Extent{1, 1} &&
           std::ranges::any_of(look.parameters, [&](const Parameter& parameter) {
               return parameter.name.starts_with(sized.scope) &&
                      follows(sized, parameter.name.substr(sized.scope.size()));
           });
}

std::size_t next_used_pass(const Look& look, const Plan& plan, std::size_t pass, int by) {
    const auto count =
        static_cast<std::ptrdiff_t>(std::min(look.passes.size(), plan.targets.size()));
    auto next = static_cast<std::ptrdiff_t>(pass);
    for (std::ptrdiff_t steps = 0; steps < count; ++steps) {
        next = (next + by + count) % count;
        const auto at = static_cast<std::size_t>(next);
        if (!is_idle(look, at, plan.targets[at].extent))
            return at;
    }
    return pass;
}
