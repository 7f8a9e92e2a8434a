#pragma once

#include "formats/isf/header.h"
#include "model/look/parameter.h"

/// What a person turns for an input that is no sound, by the rules of the format: without a range
/// 0..1, without a default the middle of the range, a default outside brought into it, a minimum
/// above the maximum swapped; a point without a range has one that holds its default; a bool
/// without a default is on. Colours are in the encoding of the display. Without bindings.
Parameter isf_control(const IsfInput& input);
