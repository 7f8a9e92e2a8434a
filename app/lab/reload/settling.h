#pragma once

#include "lab/reload/arrival.h"
#include "model/tuning/modulation.h"

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
