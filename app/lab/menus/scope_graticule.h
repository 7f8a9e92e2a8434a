#pragma once

#include "model/look/look.h"
#include "model/look/spec.h"

/// The parameter values that make a look's graticule match the divisions of the scope: 10 across
/// and 8 up over the whole signal. Empty if it already matches, if the signal is not a scope with
/// traces over time, or if the graticule is hidden. It uses the parameters `graticule` (strength),
/// `graticule_divisions` and `fit` (see BeamMapping).
Values scope_graticule(const Look& look, const Values& values, const Spec& signal);
