#pragma once

#include "model/picture/flash.h"

/// How fast a person lets the light of what they see change; theirs, and in no preset.
struct ComfortClamp {
    bool is_on = false;
    double most_a_second = default_most;  // of linear light, 0..1

    // Three flashes are six changes of a tenth of the greatest luminance: at 0.6 a second no more
    // than those fit into one.
    static constexpr double highest = 0.6;
    static constexpr double lowest = 0.05;
    static constexpr double default_most = 0.3;
    bool operator==(const ComfortClamp&) const = default;

    /// For each colour; red alone may change six times 20 / 320 a second.
    Light rates() const;
};
