#pragma once

#include "model/devices/sound.h"
#include "signals/signal/signal.h"

/// What a beam is played as.
struct BeamSoundFormat {
    double seconds = 10.0;
    int rate = 48000;  // samples a second
    int channels = 2;  // 2: x left, y right; 3: the current, too, 1 full
};

/// The signal as a sound for a scope in X-Y: each sample is where the beam is at its instant, on
/// the straight way between its points. Before the first point it rests in the middle.
Sound beam_sound(const Signal& signal, const BeamSoundFormat& format);
