#pragma once

#include "model/devices/sound.h"
#include "signals/beam/beam_sound.h"

#include <string>

/// The sound of a signal's text, such as "scene:ship.json"; its file is read from the working
/// folder. What another program sends is taken as far as it can be read, `problems` says what
/// cannot.
Result<Sound> play_beam(const std::string& signal, const BeamSoundFormat& format,
                        Diagnostics& problems);
