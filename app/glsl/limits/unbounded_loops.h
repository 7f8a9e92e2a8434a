#pragma once

#include <vector>

namespace glslang {
class TShader;
}

/// The warning about such a loop.
inline constexpr const char* unbounded_loop =
    "nothing limits this loop, and a loop without an end hangs the graphics driver. Count its "
    "rounds, and end it at a maximum.";

/// The lines of loops without a bound, in order: a driver that runs one without an end hangs. A
/// loop has a bound if each round compares a counter with something that the loop does not change,
/// and changes the counter in one direction, by an amount that the loop does not change either. The
/// shader must be parsed without errors, and it and its memory pool must still exist.
std::vector<int> unbounded_loops(glslang::TShader& shader);
