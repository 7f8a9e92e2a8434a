#pragma once

#include "formats/portable/portable_json.h"

/// Adds the shaders of all passes as SPIR-V, GLSL ES 3.00, HLSL and MSL, with reflection, to the
/// files and to the description. What can't be expressed or compiled is listed there.
void add_stages(const Look& look, PortableFiles& files);
