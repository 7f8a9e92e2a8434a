#pragma once

#include "glsl/annotations/hint.h"
#include "model/look/parameter.h"

/// Gives a parameter, as it was guessed, what its author's hints say. Errors, each on its hint's
/// line: hints that do not fit the type, numbers that do not fit, ends the wrong way round.
void annotate(Parameter& parameter, const Hints& hints, Diagnostics& errors);
