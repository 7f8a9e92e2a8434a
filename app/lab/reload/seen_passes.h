#pragma once

#include "model/look/look.h"

#include <string>
#include <vector>

/// Passes whose own pictures somebody looks at besides the last one's; at first all.
struct SeenPasses {
    bool are_all = true;
    std::vector<std::string> names = {};

    bool operator==(const SeenPasses&) const = default;
    /// As Executor::set_seen takes them.
    std::vector<bool> of(const Look& look) const;
};
