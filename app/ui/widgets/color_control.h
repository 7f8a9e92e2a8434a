#pragma once

#include "model/look/parameter.h"
#include "ui/widgets/form.h"

/// A swatch that opens a colour picker. The parameter is linear light; the picker uses
/// display-encoded sRGB.
ValueEdit draw_color(const Parameter& parameter, Value& value, const FormColumns& columns,
                     const Fonts& fonts);
