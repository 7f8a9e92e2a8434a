#pragma once

#include <cstdint>

/// Bytes of memory available to this process: physical memory, or the lower limit of its control
/// group (container).
std::uint64_t machine_memory();
