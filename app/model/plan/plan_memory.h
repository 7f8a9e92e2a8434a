#pragma once

#include "model/plan/plan.h"

#include <cstdint>

/// About how many bytes drawing by a plan takes: its targets with all pictures that they keep, and
/// their smaller levels (a third more); `picture` once more, read as 32-bit floats and encoded.
std::uint64_t estimated_bytes(const Plan& plan, Extent picture);
