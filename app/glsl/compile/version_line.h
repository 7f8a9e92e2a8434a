#pragma once

#include "model/look/look.h"

/// Reports a stage without a #version for an OpenGL core profile, with a suggestion.
Diagnostics check_version(const Stage& stage);
