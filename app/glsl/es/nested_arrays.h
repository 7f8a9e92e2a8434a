#pragma once

#include <cstdint>
#include <vector>

/// The same SPIR-V module without arrays of arrays, which GLSL ES 3.00 lacks: each inner array is
/// the only member of a structure.
std::vector<std::uint32_t> without_nested_arrays(std::vector<std::uint32_t> code);
