#pragma once

#include "model/look.h"

#include <string>
#include <vector>

class Lab;
struct WindowState;

/// Passes whose own pictures somebody looks at besides the last one's; at first all.
struct SeenPasses {
    bool are_all = true;
    std::vector<std::string> names = {};

    bool operator==(const SeenPasses&) const = default;
    /// As Executor::set_seen takes them.
    std::vector<bool> of(const Look& look) const;
};

/// What a window shows of the look that is open: all passes in the strip and where pins are told,
/// else the picture and what is looked into.
SeenPasses seen_passes(const Lab& lab, const WindowState& window);
