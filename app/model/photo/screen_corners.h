#pragma once

#include "model/look/picture.h"
#include "model/photo/camera.h"

#include <optional>

/// The corners of a screen in a photo, from its straight edges: lines with light inside and dark
/// outside. A first guess. nullopt: the photo does not show four such edges, or the screen
/// fills the photo. `photo`: display
/// values, 3 or 4 channels.
std::optional<Corners> guess_corners(const Picture& photo);
