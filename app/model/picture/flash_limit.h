#pragma once

#include "model/picture/flash.h"

/// Limits how fast displayed light may change. A user setting, not part of presets.
struct FlashLimit {
    bool is_on = false;
    double max_per_second = default_maximum;  // of linear light 0..1, per second

    // Three flashes are six changes of a tenth of the maximum luminance. At 0.6 per second at most
    // these fit into one second.
    static constexpr double highest = 0.6;
    static constexpr double lowest = 0.05;
    static constexpr double default_maximum = 0.3;
    bool operator==(const FlashLimit&) const = default;

    /// Per channel and second; red alone may change by at most six times 20 / 320.
    Light rates() const;
};
