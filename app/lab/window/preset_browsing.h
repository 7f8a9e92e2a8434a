#pragma once

#include <string>

/// The filter of the preset browser, and the duration of a morph.
struct PresetBrowsing {
    std::string search;
    bool only_starred = false;       // also for the next and previous preset keys
    bool shows_own_content = false;  // pictures show the user's signal or source
    double morph_seconds = 3.0;
    bool has_offered_move = false;  // offered to move presets out of the program's folder

    bool operator==(const PresetBrowsing&) const = default;
};
