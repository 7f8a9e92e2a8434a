#include "signals/patterns/generated_picture.h"

#include "signals/patterns/patterns.h"
#include "signals/patterns/solids.h"

#include <cassert>

namespace {
constexpr std::string_view pattern_prefix = "pattern:";
constexpr std::string_view solid = "solid:";
}  // namespace

std::optional<std::string_view> made_name(std::string_view choice) {
    for (const std::string_view prefix : {pattern_prefix, solid})
        if (choice.starts_with(prefix))
            return choice.substr(prefix.size());
    return std::nullopt;
}

Result<Picture> made_picture(const std::string& name) {
    if (name.starts_with(pattern_prefix))
        return make_pattern(std::string_view(name).substr(pattern_prefix.size()));
    assert(name.starts_with(solid));
    return make_solid(std::string_view(name).substr(solid.size()));
}
