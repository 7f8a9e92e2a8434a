#pragma once

#include "model/look/look.h"

/// The look's values on the way from one set to another, at `share` 0 .. 1 of it. Numbers go
/// straight, on logarithmic sliders in equal ratios; colours as the linear light that they are;
/// angles that go all round the shorter way. Whole numbers, lists, switches and files change at
/// half.
Values morphed(const Look& look, const Values& from, const Values& to, double share);
