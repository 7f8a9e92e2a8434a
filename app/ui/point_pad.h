#pragma once

#include "model/parameter.h"
#include "ui/form.h"

/// A pad for a point (x to the right, y up) with its two numbers below.
Turned draw_point(const Parameter& parameter, Value& value, const NumberFacts& facts,
                  const FormColumns& columns, const Fonts& fonts);
