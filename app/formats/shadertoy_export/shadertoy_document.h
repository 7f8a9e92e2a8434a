#pragma once

#include "formats/shadertoy_export/shadertoy_images.h"

#include <string>
#include <vector>

/// A Shadertoy shader to write.
struct ShadertoyDocument {
    struct Pass {
        int buffer = -1;  // 0: Buffer A; below 0: the image
        std::string code;
        std::vector<ShadertoyConnection> channels;
    };

    std::string name;
    std::string author;
    std::string about;
    std::string common;        // "": none
    bool is_upright = true;    // row 0 of the picture is at the bottom
    std::vector<Pass> passes;  // the image is first
};

/// The JSON of the site's exports and of its API, with the keys of both.
std::string shadertoy_json(const ShadertoyDocument& document);
