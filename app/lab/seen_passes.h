#pragma once

#include "model/look/look.h"

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

/// What a window shows in every frame of the look that is open: the picture and what is looked
/// into. What the strip and the pins show of others, a few times a second, is drawn once more then.
SeenPasses seen_passes(const Lab& lab, const WindowState& window);
