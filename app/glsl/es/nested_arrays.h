#pragma once

#include <cstdint>
#include <vector>

/// The same SPIR-V module without arrays of arrays, which GLSL ES 3.00 lacks: each becomes one
/// array of all elements. Unchanged if an inner array is used as a whole, or if its length is not
/// known.
std::vector<std::uint32_t> without_nested_arrays(std::vector<std::uint32_t> code);
