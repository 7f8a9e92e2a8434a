#pragma once

#include "lab/reload/seen_passes.h"

class Lab;
struct WindowState;

/// What a window shows in every frame of the look that is open: the picture and what is looked
/// into. What the strip and the pins show of others, a few times a second, is drawn once more then.
SeenPasses displayed_passes(const Lab& lab, const WindowState& window);
