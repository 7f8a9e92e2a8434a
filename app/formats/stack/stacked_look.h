#pragma once

#include "model/look/look.h"

#include <vector>

/// One look that draws the parts of `stack` one after the other; `looks` has their looks in the
/// same order. Names of passes, parameters and images begin with their part's key ("crt/exposure").
/// The last pass of a look is the source of the next; where they differ in encoding a pass called
/// "crt/source" stands between. Bypassed parts keep their parameters and have no pass. What comes
/// before a look that reads no picture is not seen and not drawn; `warnings` says so.
Look stacked_look(const std::vector<Look>& looks, const Stack& stack, Diagnostics& warnings);
