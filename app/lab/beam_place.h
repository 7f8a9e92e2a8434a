#pragma once

#include "model/look.h"
#include "model/parameter.h"
#include "signals/drawing.h"

#include <array>

/// A pixel of the picture, from its top left corner.
using PicturePixel = std::array<double, 2>;

/// How the beam's places lie in a look's picture, so that a person can point at one. A look says it
/// by three parameters, which need not be there: `fit` (its item "Keep circles round": both axes at
/// the scale of the shorter one), `screen_size` (how much of the picture -1..1 takes) and
/// `curvature` (of include/glass.glsl's barrel).
class BeamPlacing {
public:
    /// Of the look that the signal drives: in a stack the first.
    BeamPlacing(const Look& look, const Values& values, Extent picture);

    /// The place at which a beam shows in this pixel.
    BeamPlace place_of(const PicturePixel& pixel) const;
    PicturePixel pixel_of(const BeamPlace& place) const;
    /// What a pixel in the middle covers, in half screens.
    double pixel_size() const;

private:
    Extent m_picture;
    std::array<double, 2> m_size{1.0, 1.0};  // of -1..1, as shares of the picture
    double m_curvature = 0.0;
};
