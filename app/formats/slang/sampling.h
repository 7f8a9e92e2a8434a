#pragma once

#include "formats/slang/preset.h"

/// How what a chain's passes read is sampled. As in RetroArch, filter and wrap belong to the
/// texture and not to its reader: an output has those of the pass behind it, a feedback those of
/// the pass that drew it, the original those of the first pass.
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
