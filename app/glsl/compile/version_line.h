#pragma once

#include "model/look/look.h"

/// Whether a stage starts with a #version that an OpenGL core profile takes; else what to write.
Diagnostics check_version(const Stage& stage);
