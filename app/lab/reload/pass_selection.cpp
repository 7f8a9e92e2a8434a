#include "lab/reload/pass_selection.h"

#include <algorithm>

std::vector<bool> PassSelection::of(const Look& look) const {
    if (are_all || look.passes.empty())
        return {};
    std::vector<bool> displayed;
    for (const Pass& pass : look.passes)
        displayed.push_back(std::ranges::find(names, pass.name) != names.end());
    displayed.back() = true;
    return displayed;
}
