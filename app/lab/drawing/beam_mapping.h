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

/// The distortion of a curved glass. Positions are -1..1 in x and y.
struct GlassDistortion {
    enum class Kind {
        crossed,  // barrel() of include/glass.glsl: each axis scales with the other
        radial    // barrel_radial() of include/barrel.glsl
    };
    Kind kind = Kind::crossed;
    double amount = 0.0;

    /// The position behind the glass that appears at `position`, and the inverse.
    BeamPosition behind(const BeamPosition& position) const;
    BeamPosition shown(const BeamPosition& position) const;
};

/// Maps between pixels of a look's picture and beam positions, for pointing. It depends on three
/// optional parameters. `fit` with "Keep circles round": both axes have the scale of the shorter
/// one. `screen_size`: the share of the picture that -1..1 covers. `curvature`: the amount of a
/// glass curve. In a stack, the look with the signal positions the beam. Every later look with a
/// `curvature` distorts its picture.
class BeamMapping {
public:
    /// `fit`: as set by the signal; nullopt: the look's own.
    BeamMapping(const Look& look, const Values& values, Extent picture,
                std::optional<Fit> fit = {});

    /// The beam position that appears in this pixel.
    BeamPosition position_of(const PicturePixel& pixel) const;
    PicturePixel pixel_of(const BeamPosition& position) const;
    /// The size of a pixel at the centre, in half screens.
    double pixel_size() const;

private:
    Extent m_picture;
    std::array<double, 2> m_size{1.0, 1.0};  // of -1..1, relative to the picture
    std::vector<GlassDistortion> m_glasses;  // from the beam to the viewer
};
