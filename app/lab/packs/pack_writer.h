#pragma once

#include "base/diagnostic.h"
#include "formats/pack/pack_format.h"
#include "lab/library/library.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

struct PackRequest {
    std::vector<std::string> looks;  // looks, stacks, presets or shaders of other programs
    std::filesystem::path path;      // of the pack
};

struct WrittenPack {
    PackManifest manifest;
    std::size_t files = 0;
    std::uintmax_t bytes = 0;
    Diagnostics warnings;  // thumbnails that could not be drawn
};

/// Called with the share that is done, 0 to 1. False cancels.
using PackProgress = std::function<bool(double share)>;

/// Writes a pack with thumbnails, 240 x 135 px. An existing file is replaced, or unchanged on an
/// error.
Result<WrittenPack> write_pack(const PackRequest& request, const Library& library,
                               const PackProgress& progress);
