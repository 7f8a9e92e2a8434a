#pragma once

struct FlashDisplay;
struct Workspace;
class Messages;

/// Lets the look draw sub-frames if the user allows its flicker, and no flash limiter is on. Asks
/// the first time that a display is fast enough for the sub-frames of a look. A dismissed question
/// is not repeated until the next start.
void follow_flicker(Workspace& work, FlashDisplay& flashes);

/// Warns of photosensitive epilepsy, and asks whether to allow flicker.
void ask_about_flicker(Messages& messages);
