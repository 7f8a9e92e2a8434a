#pragma once

#include "formats/slang/preset.h"

/// Sampler states of the textures in a chain. As in RetroArch, filter and wrap belong to the
/// texture, not to its reader. An output has those of the next pass, a feedback those of its own
/// pass, the original those of the first pass.
class SlangSampling {
public:
    SlangSampling(const SlangPreset& preset, Filter unspecified)
        : m_preset(preset), m_unspecified(unspecified) {}

    Sampler of_original() const { return state_of(0, false); }
    /// The output of the pass before `reader`.
    Sampler of_source(int reader) const { return state_of(reader, has_levels(reader - 1)); }
    Sampler of_output(int pass) const { return state_of(pass + 1, has_levels(pass)); }
    Sampler of_feedback(int pass) const { return state_of(pass, has_levels(pass)); }
    Sampler of_image(int texture) const;

private:
    bool has_levels(int pass) const;
    Sampler state_of(int pass, bool is_mipmapped) const;

    const SlangPreset& m_preset;
    Filter m_unspecified;
};
