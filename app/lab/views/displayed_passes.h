#pragma once

#include "lab/reload/pass_selection.h"

class Lab;
struct WindowState;

/// The passes that a window displays in every frame: the picture, the inspected and the probed
/// pass. The strip and the pins display others only a few times a second; those are drawn again
/// then.
PassSelection displayed_passes(const Lab& lab, const WindowState& window);
