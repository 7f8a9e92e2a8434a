#pragma once

#include "model/devices/sound.h"
#include "signals/beam/beam_sound.h"

#include <string>

/// Renders the sound of a signal such as "scene:ship.json"; its file is relative to the working
/// directory. A beam from another program is read as far as it is valid; `problems` gets its
/// errors.
Result<Sound> play_beam(const std::string& signal, const BeamSoundFormat& format,
                        Diagnostics& problems);
