#pragma once

#include "model/look/extent.h"
#include "model/look/look.h"
#include "model/picture/source_spec.h"

#include <array>
#include <optional>
#include <string>

/// Whether the look of a stack whose names begin with `scope` draws both axes of its beam at one
/// scale: the item "Keep circles round" of its parameter `fit`.
bool keeps_circles_round(const Look& look, const Values& values, const std::string& scope);

/// By how much x and y of the beam's places are multiplied before the look draws them, so that
/// -1..1 lies in a picture of `picture` pixels as the signal asks: stretched over it, whole with
/// round circles, or cropped with round circles. {1, 1} without a fit: as the look has it.
std::array<double, 2> beam_scale(const Look& look, const Values& values, Extent picture,
                                 std::optional<Fit> fit);
