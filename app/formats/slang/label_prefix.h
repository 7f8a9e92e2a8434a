#pragma once

#include "model/look/parameter.h"

#include <vector>

/// Takes the words that all labels of a group begin with ("CRTGeom Curvature", "CRTGeom X Size")
/// off them, where the group has four parameters at least and every label goes on with a letter.
/// The label in full becomes the help of a parameter without one.
void drop_common_prefixes(std::vector<Parameter>& parameters);
