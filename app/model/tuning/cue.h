#pragma once

#include <string>

/// One line of a cue file: what happens at a time.
struct Cue {
    enum class Command { preset, parameter, restart, blackout };

    double seconds = 0.0;  // position in the sound; without a sound, time of the clock
    Command command = Command::preset;
    std::string name = {};   // of the preset or the parameter
    std::string value = {};  // of the parameter, as typed after --set
    double over = 0.0;       // s, duration of the morph or the change
    bool is_on = true;       // of blackout

    bool operator==(const Cue&) const = default;
};
