#pragma once

#include "glsl/annotations/hint.h"
#include "model/look/parameter.h"

/// Applies the hints to a guessed parameter. Errors, each on its hint's line: hints or numbers that
/// do not fit the type, ranges in the wrong order.
void annotate(Parameter& parameter, const Hints& hints, Diagnostics& errors);
