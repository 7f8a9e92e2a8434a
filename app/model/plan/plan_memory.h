#pragma once

#include "model/plan/plan.h"

#include <cstdint>

/// Approximate bytes for drawing by a plan. Includes its targets with all stored pictures and mip
/// levels (a third more), and `picture` read as 32-bit floats and encoded.
std::uint64_t estimated_bytes(const Plan& plan, Extent picture);
