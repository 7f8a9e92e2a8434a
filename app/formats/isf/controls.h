#pragma once

#include "formats/isf/header.h"
#include "model/look/parameter.h"

/// The parameter for an input other than sound, by the rules of the format. The default range is
/// 0..1, and the default value is the middle of the range. A default outside the range is clamped,
/// and a minimum above the maximum is swapped. A point without a range gets one that contains its
/// default. A bool without a default is on. Colours are display-encoded. Without bindings.
Parameter isf_control(const IsfInput& input);
