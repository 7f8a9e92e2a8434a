#pragma once

#include "model/look/parameter.h"
#include "ui/widgets/form.h"

/// A pad for a point (x to the right, y up) with its numbers below. `now`: its modulated position,
/// drawn as a ring; may be null.
ValueEdit draw_point(const Parameter& parameter, Value& value, const Value* now,
                     const NumberInfo& info, const FormColumns& columns, const Fonts& fonts);
