#pragma once

#include "model/look/look.h"
#include "model/look/parameter.h"
#include "model/picture/source_spec.h"
#include "signals/drawing/drawing.h"

#include <array>
#include <optional>
#include <vector>

/// A pixel of the picture, from its top left corner.
using PicturePixel = std::array<double, 2>;

/// How glass bends what is behind it. Places are -1..1 in x and y.
struct GlassCurve {
    enum class Kind {
        crossed,  // barrel() of include/glass.glsl: each axis grows with the other
        radial    // barrel_radial() of include/barrel.glsl
    };
    Kind kind = Kind::crossed;
    double amount = 0.0;

    /// The place behind the glass that shows at `place`, and where one shows.
    BeamPlace behind(const BeamPlace& place) const;
    BeamPlace shown(const BeamPlace& place) const;
};

/// How the beam's places lie in a look's picture, so that a person can point at one. A look says it
/// by three parameters, which need not be there: `fit` (its item "Keep circles round": both axes at
/// the scale of the shorter one), `screen_size` (how much of the picture -1..1 takes) and
/// `curvature` (of one of the curves above). In a stack the look that the signal drives says where
/// the beam is, and every look after it that has a `curvature` bends its picture.
class BeamPlacing {
public:
    /// `fit`: as the signal asks; none: as the look has it.
    BeamPlacing(const Look& look, const Values& values, Extent picture,
                std::optional<Fit> fit = {});

    /// The place at which a beam shows in this pixel.
    BeamPlace place_of(const PicturePixel& pixel) const;
    PicturePixel pixel_of(const BeamPlace& place) const;
    /// What a pixel in the middle covers, in half screens.
    double pixel_size() const;

private:
    Extent m_picture;
    std::array<double, 2> m_size{1.0, 1.0};  // of -1..1, as shares of the picture
    std::vector<GlassCurve> m_glasses;       // from the beam to the eye
};
