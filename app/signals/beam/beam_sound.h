#pragma once

#include "model/devices/sound.h"
#include "signals/signal/signal.h"

/// Format and duration of a beam that is converted to sound.
struct BeamSoundFormat {
    double seconds = 10.0;
    int rate = 48000;  // samples per second
    int channels = 2;  // 2: x left, y right; 3: also the current, 1 = full
};

/// The signal as a sound for a scope in X-Y mode. Samples are linearly interpolated between the
/// beam's points. Before the first point the beam is at the centre.
Sound beam_sound(const Signal& signal, const BeamSoundFormat& format);
