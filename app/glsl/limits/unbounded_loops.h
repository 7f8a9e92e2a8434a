#pragma once

#include <vector>

namespace glslang {
class TShader;
}

/// The lines of loops without a bound, in order: a driver that runs one without an end hangs. A
/// loop has a bound if each round compares a counter with something that the loop does not change,
/// and changes the counter in one direction, by an amount that the loop does not change either. The
/// shader must be parsed without errors, and it and its memory pool must still exist.
std::vector<int> unbounded_loops(glslang::TShader& shader);
