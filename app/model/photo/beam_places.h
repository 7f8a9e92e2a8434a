#pragma once

#include "model/photo/beam_profile.h"
#include "model/photo/camera.h"

#include <optional>

/// Where a photo of a beam shows its profile.
struct BeamPlaces {
    std::optional<BeamPlace> line;  // straight, with nothing else within the reach
    std::optional<BeamPlace> dot;   // likewise
    bool are_overexposed = false;   // others would have been found, with a channel at its maximum
};

/// Searches the screen between the corners. Of several lines, the narrowest; of several dots, the
/// brightest. `photo`: display values, 3 or 4 channels. `map`: its light.
/// `reach`: px.
BeamPlaces find_beam_places(const Picture& photo, const LightMap& map, const Corners& corners,
                            double reach);
