#pragma once

#include "model/look/extent.h"
#include "model/look/texture_choice.h"

#include <optional>
#include <string>
#include <vector>

/// What one sampler of a pass reads, as it is bound.
struct SamplerReport {
    std::string uniform;
    std::optional<TextureChoice> reads;  // none: nothing feeds it
    Extent extent;  // px; empty: nothing is there, and it reads transparent black
    Format format = Format::rgba8;
    Sampler sampler;
};

/// A uniform that the program itself drives, with the numbers that it had last.
struct BuiltInReport {
    std::string name;
    std::vector<double> numbers;
};

/// What a pass was told by the last frame that was drawn.
struct PassReport {
    std::vector<SamplerReport> samplers;
    std::vector<BuiltInReport> built_ins;
};
