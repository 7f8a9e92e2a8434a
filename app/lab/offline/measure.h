#pragma once

#include "lab/offline/offline.h"

#include <string>
#include <vector>

struct PassTime {
    std::string name;
    double milliseconds = 0.0;  // GPU time
};

/// The cost of a frame of a look; medians.
struct Measurement {
    double cpu_milliseconds = 0.0;  // of all threads, including glFinish
    double wall_milliseconds = 0.0;
    std::vector<PassTime> passes;
    int draw_calls = 0;
    double bytes_per_pixel = 0.0;
    std::size_t target_bytes = 0;  // memory of all targets
    std::string renderer;
};

struct MeasureSettings {
    int frames = 60;
    bool is_generic = false;  // keep the programs that draw while a value changes
};

/// Specialises the programs by default, draws some frames for warm-up, then measures.
Result<Measurement> measure(Offline& offline, const MeasureSettings& settings);
