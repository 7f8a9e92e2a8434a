#pragma once

#include "model/look/look.h"

#include <string>
#include <vector>

/// The displayed passes in addition to the last one; initially all.
struct SeenPasses {
    bool are_all = true;
    std::vector<std::string> names = {};

    bool operator==(const SeenPasses&) const = default;
    /// In the form of Executor::set_seen.
    std::vector<bool> of(const Look& look) const;
};
