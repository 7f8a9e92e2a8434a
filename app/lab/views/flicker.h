#pragma once

struct FlashDisplay;
struct Workspace;

/// Lets the look draw sub-frames if the user allows its flicker, and no flash limiter is on. Asks
/// the first time that a display is fast enough for the sub-frames of a look.
void follow_flicker(Workspace& work, FlashDisplay& flashes);
