#pragma once

#include <cstdint>

/// Bytes of memory that this process may have: those of the machine, or fewer where it runs in a
/// control group with a bound (a container).
std::uint64_t machine_memory();
