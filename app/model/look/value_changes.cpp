#include "model/look/value_changes.h"

#include <algorithm>

namespace {
// Sorted. A missing value may still equal the other by its default.
std::vector<std::string> names_of_differences(const Values& before, const Values& now) {
    std::vector<std::string> names;
    auto one = before.begin();
    auto other = now.begin();
    while (one != before.end() || other != now.end()) {
        const bool is_lost =
            other == now.end() || (one != before.end() && one->first < other->first);
        const bool is_new = !is_lost && (one == before.end() || other->first < one->first);
        if (is_lost || is_new || one->second != other->second)
            names.push_back(is_lost ? one->first : other->first);
        if (!is_new)
            ++one;
        if (!is_lost)
            ++other;
    }
    return names;
}
}  // namespace

std::vector<std::string> changed_parameters(const Look& look, const Values& before,
                                            const Values& now) {
    std::vector<std::string> names = names_of_differences(before, now);
    if (names.empty())
        return names;
    std::vector<std::string> changed;
    for (const Parameter& parameter : look.parameters)
        if (std::ranges::binary_search(names, parameter.name) &&
            value_of(parameter, before) != value_of(parameter, now))
            changed.push_back(parameter.name);
    std::ranges::sort(changed);
    return changed;
}

void follow_values(Values& held, const Values& now) {
    auto one = held.begin();
    for (const auto& [name, value] : now) {
        while (one != held.end() && one->first < name)
            one = held.erase(one);
        if (one == held.end() || one->first != name)
            one = held.emplace_hint(one, name, value);
        else if (one->second != value)
            one->second = value;
        ++one;
    }
    held.erase(one, held.end());
}
