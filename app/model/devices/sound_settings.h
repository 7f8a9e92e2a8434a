#pragma once

#include <string>

/// The user's choice of sound devices, and their settings.
struct SoundSettings {
    std::string output;  // a device's name; "": the system's default
    std::string input;
    int rate = 0;                   // samples per second; 0: the device's preferred rate
    int buffer = 512;               // sample frames
    double picture_delay_ms = 0.0;  // delays the picture relative to the sound; < 0: earlier
    // Outputs the beam to a real scope: x left, y right. Never saved, so that no start sends it to
    // loudspeakers unexpectedly.
    bool plays_beam = false;
    double beam_level = 0.5;  // full deflection relative to full scale; 0 .. 1

    bool operator==(const SoundSettings&) const = default;
};
