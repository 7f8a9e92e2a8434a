#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Where the sound is, with a bar to seek in, how loud it plays; of a live sound what it comes
/// in from.
void draw_sound_controls(bool is_live, const Scene& scene, Edits& edits);
/// Why nothing is heard, or comes in; how the beam of another program stands.
void draw_silence(const Scene& scene);
/// The devices that a person may choose among.
void draw_sound_devices(bool is_live, const Scene& scene, Edits& edits);

/// "1:02.34".
std::string clock_text(double seconds);
