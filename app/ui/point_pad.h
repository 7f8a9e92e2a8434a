#pragma once

#include "model/parameter.h"
#include "ui/form.h"

/// A pad for a point (x to the right, y up) with its two numbers below.
Turned draw_point(const Parameter& parameter, Value& value, bool is_changed,
                  const FormColumns& columns, const Fonts& fonts);
