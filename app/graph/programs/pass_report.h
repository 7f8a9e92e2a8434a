#pragma once

#include "model/look/extent.h"
#include "model/look/texture_choice.h"

#include <optional>
#include <string>
#include <vector>

/// The texture that is bound to a sampler of a pass.
struct SamplerReport {
    std::string uniform;
    std::optional<TextureChoice> reads;  // nullopt: not connected
    Extent extent;                       // px; empty: without a texture, reads transparent black
    Format format = Format::rgba8;
    Sampler sampler;
};

/// A built-in uniform and its last numbers.
struct BuiltInReport {
    std::string name;
    std::vector<double> numbers;
};

/// The samplers and built-in uniforms of a pass in the last drawn frame.
struct PassReport {
    std::vector<SamplerReport> samplers;
    std::vector<BuiltInReport> built_ins;
};
