#pragma once

#include <cstddef>
#include <vector>

/// Decoded sound in memory: floats, nominally -1..1, interleaved channels.
struct Sound {
    int rate = 0;  // sample frames per second
    int channels = 0;
    std::vector<float> samples;

    std::size_t frame_count() const {
        return channels > 0 ? samples.size() / static_cast<std::size_t>(channels) : 0;
    }
    double seconds() const { return rate > 0 ? static_cast<double>(frame_count()) / rate : 0.0; }
};
