#pragma once

#include "base/diagnostic.h"

#include <RtAudio.h>

#include <functional>
#include <string>
#include <vector>

/// What the sound library has for this machine, sound servers first: they share a device with other
/// programs.
std::vector<RtAudio::Api> usable_sound_apis();

enum class SoundDirection { out, in };

/// The device of that name, or the default for "". Throws RtAudioError, also when there is none.
unsigned int find_sound_device(RtAudio& audio, const std::string& name, SoundDirection direction);

/// Calls `open` for each usable API until it gives true. An error is its last reason for not doing
/// so, `what` being a word for the device.
Result<void> open_first_sound_device(const std::string& what,
                                     const std::function<bool(RtAudio::Api)>& open);
