#include "lab/document/naming.h"

#include "base/text.h"
#include "model/look/stack.h"

#include <fmt/format.h>

Result<const Parameter*> resolve_parameter(const std::string& name, const Look& look) {
    std::vector<std::string> candidates;
    const std::vector<std::string> names = parameter_names(look);
    if (const auto meant = resolve_name(names, name, candidates))
        return find_parameter(look, *meant);
    if (!candidates.empty())
        return fail({{},
                     0,
                     fmt::format("several looks have a parameter '{}'; use one of: {}", name,
                                 fmt::join(candidates, ", "))});
    return fail(
        {{},
         0,
         fmt::format("'{}' has no parameter '{}'{}", look.id, name, did_you_mean(name, names))});
}
