#pragma once

#include "model/look/look.h"
#include "model/look/spec.h"

/// What a look's graticule must be set to so that its lines are the divisions of the scope that
/// `signal` shows traces over time on: 10 across and 8 up, over the whole signal. Empty where they
/// are, where the signal is no such scope, and where no graticule is seen. A look says it by the
/// parameters `graticule` (how strongly it shows), `graticule_divisions` and `fit` (see
/// BeamPlacing).
Values scope_graticule(const Look& look, const Values& values, const Spec& signal);
