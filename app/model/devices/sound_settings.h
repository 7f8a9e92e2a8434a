#pragma once

#include <string>

/// The sound devices that a person has chosen, and how they are used.
struct SoundSettings {
    std::string output;  // a device's name; "": the system's own choice
    std::string input;
    int rate = 0;                   // samples a second; 0: the device's own
    int buffer = 512;               // sample frames
    double picture_delay_ms = 0.0;  // the picture waits so long for what is heard; < 0: it is ahead
    // The beam goes out to a real scope: x left, y right. Never kept: no start is to surprise
    // loudspeakers.
    bool plays_beam = false;
    double beam_level = 0.5;  // full deflection, of full scale; 0 .. 1

    bool operator==(const SoundSettings&) const = default;
};
