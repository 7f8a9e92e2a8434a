#pragma once

#include "graph/inspect/tripwire.h"

#include <optional>

/// The user's choice for handling a NaN or infinity.
enum class TripAnswer {
    clear,  // restart history
    clamp,  // replace with finite values
    go_on,  // ignore
};

/// The state of the NaN detector and its handling.
struct TripState {
    std::optional<Trip> trip;          // the finding that stopped the clock
    std::optional<TripAnswer> answer;  // valid until the look changes
    bool is_unattended = false;
    bool has_told = false;
    bool plays_after = false;  // resume playback when an edit fixes the problem
};
