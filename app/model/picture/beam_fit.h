#pragma once

#include "model/look/extent.h"
#include "model/look/look.h"
#include "model/picture/source_spec.h"

#include <array>
#include <optional>
#include <string>

/// Whether a look draws both axes of its beam at the same scale: the item "Keep circles round" of
/// its parameter `fit`. `scope` is the name prefix of the look in a stack.
bool keeps_circles_round(const Look& look, const Values& values, const std::string& scope);

/// Factors for the beam's x and y before the look draws them, so that -1..1 fits a picture of
/// `picture` pixels. The fit is stretched, whole with round circles, or cropped with round circles.
/// {1, 1} without a fit: as the look draws it.
std::array<double, 2> beam_scale(const Look& look, const Values& values, Extent picture,
                                 std::optional<Fit> fit);
