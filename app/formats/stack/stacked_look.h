#pragma once

#include "model/look/look.h"

#include <vector>

/// A look that draws the parts of `stack` in sequence. `looks` has their looks in the same order.
/// Names of passes, parameters and images start with the key of their part ("crt/exposure"). The
/// last pass of a look is the source of the next. A pass "crt/source" converts between different
/// encodings. Bypassed parts keep their parameters and have no pass. Looks before one that does not
/// use a picture are not drawn, with a warning in `warnings`.
Look stacked_look(const std::vector<Look>& looks, const Stack& stack, Diagnostics& warnings);
