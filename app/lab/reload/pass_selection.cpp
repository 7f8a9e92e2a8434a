#include "lab/reload/pass_selection.h"

#include <algorithm>

std::vector<bool> PassSelection::of(const Look& look) const {
    if (are_all || look.passes.empty())
        return {};
    std::vector<bool> seen;
    for (const Pass& pass : look.passes)
        seen.push_back(std::ranges::find(names, pass.name) != names.end());
    seen.back() = true;
    return seen;
}
