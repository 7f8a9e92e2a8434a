#pragma once

#include "lab/reload/arrival.h"
#include "model/tuning/modulation.h"

#include <chrono>
#include <memory>
#include <optional>

/// How far the open look is on its way to programs that hold its values as constants.
struct Settling {
    Values values;  // that rest
    Modulations modulations;
    double seconds = 0.0;  // for so long
    bool is_asked = false;
    std::unique_ptr<Arrival> arrival = {};  // of the programs; null: they are not there yet
    std::shared_ptr<const Rest> rest = {};  // that the picture was last settled for
};

/// The programs of an edit in which all can be turned, while they are drawn with for the first time
/// behind its picture, which settled ones draw.
struct OwnPrograms {
    bool are_late = false;                             // what a hand turns waits for them
    std::chrono::steady_clock::time_point since = {};  // since the edit's picture came
    std::unique_ptr<Arrival> arrival = {};             // null: the reloader is still at them
    std::optional<LoadedRequest> edit = {};  // no picture yet: values did not rest any more
};
