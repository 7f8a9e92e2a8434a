#pragma once

#include "lab/offline/offline.h"

#include <string>
#include <vector>

struct PassTime {
    std::string name;
    double milliseconds = 0.0;  // on the GPU's clock
};

/// What a frame of a look costs; medians.
struct Measurement {
    double cpu_milliseconds =
        0.0;  // of the whole process, all threads, the frame ending in glFinish
    double wall_milliseconds = 0.0;
    std::vector<PassTime> passes;
    int draw_calls = 0;
    double bytes_per_pixel = 0.0;
    std::size_t target_bytes = 0;  // that the targets take
    std::string renderer;
};

/// Settles the values, draws some frames to warm up, then `frames` that count.
Result<Measurement> measure(Offline& offline, int frames);
