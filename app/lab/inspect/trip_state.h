#pragma once

#include "graph/inspect/tripwire.h"

#include <optional>

/// What a person wants done about a number that is not finite.
enum class TripAnswer {
    clear,  // history begins anew
    clamp,  // such numbers become finite ones
    go_on,  // they are left as they are
};

/// What is known and wanted about numbers that are not finite.
struct TripState {
    std::optional<Trip> trip;          // that has stopped the clock
    std::optional<TripAnswer> answer;  // that holds until the look changes
    bool is_unattended = false;
    bool has_told = false;
    bool plays_after = false;  // time flowed, and will when another value or text is the cure
};
