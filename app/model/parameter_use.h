#pragma once

#include "model/look.h"

/// Whether a pass uses a parameter: in its shaders, for its size, or for how often it draws.
bool is_used_by(const Look& look, std::size_t pass, const Parameter& parameter);
