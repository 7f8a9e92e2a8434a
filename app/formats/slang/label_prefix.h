#pragma once

#include "model/look/parameter.h"

#include <vector>

/// Removes the words that start all labels of a group ("CRTGeom Curvature", "CRTGeom X Size"). The
/// group must have at least four parameters, and the rest of each label must start with a letter.
/// The full label becomes the help of a parameter without one.
void drop_common_prefixes(std::vector<Parameter>& parameters);
