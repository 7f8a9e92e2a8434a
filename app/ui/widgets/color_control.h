#pragma once

#include "model/look/parameter.h"
#include "ui/widgets/form.h"

/// A swatch that opens a picker. The parameter is linear light; a person sees and picks the
/// display-encoded colour.
Turned draw_color(const Parameter& parameter, Value& value, const FormColumns& columns,
                  const Fonts& fonts);
