#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Seek bar and volume of the sound; for live sound the name of the input device.
void draw_sound_controls(bool is_live, const Scene& scene, Edits& edits);
/// Errors of sound output and input, and the state of the beam to or from another program.
void draw_audio_error(const Scene& scene);
/// The choice of audio devices.
void draw_sound_devices(bool is_live, const Scene& scene, Edits& edits);

/// "1:02.34".
std::string clock_text(double seconds);
