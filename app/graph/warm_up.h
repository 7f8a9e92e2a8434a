#pragma once

#include "graph/programs.h"
#include "model/extent.h"

/// Draws once with each program of `programs` that `known` lacks, into targets of the look's
/// formats but a few pixels large. A driver makes a program's code when it is first drawn with, for
/// the states that it meets there; done here, on a helper thread whose context shares with the
/// drawing one, the picture does not wait for it. `viewport` is the size that the picture will
/// have. Programs in `known` may be in use and are not touched.
void warm_up(const Look& look, const Programs& programs, const Programs* known, Extent viewport);
