#pragma once

#include <string>
#include <string_view>

/// The same GLSL in fewer bytes: without needless blanks and line ends, and with 32-bit numbers in
/// their shortest form (0.1 instead of 0.100000001490116119384765625). Names are unchanged. Each
/// function starts a line.
std::string compact_glsl(std::string_view text);
