#pragma once

#include "io/files/zip.h"

/// The limits of a pack: 10,000 files, 2 GB unpacked, and 100 times its packed size.
inline constexpr ZipLimits pack_limits{10'000, 2'000'000'000, 100.0};
