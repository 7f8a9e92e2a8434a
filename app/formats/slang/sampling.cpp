#include "formats/slang/sampling.h"

namespace {
Filter filter_of(std::optional<bool> is_linear, Filter unspecified) {
    if (!is_linear)
        return unspecified;
    return *is_linear ? Filter::linear : Filter::nearest;
}
}  // namespace

// Whether the pass has mipmaps, because the next pass reads them.
bool SlangSampling::has_levels(int pass) const {
    const std::size_t next = static_cast<std::size_t>(pass) + 1;
    return next < m_preset.passes.size() && m_preset.passes[next].reads_mipmaps;
}

// RetroArch interpolates between mipmap levels only in the state of a pass with mipmaps.
Sampler SlangSampling::state_of(int pass, bool is_mipmapped) const {
    const SlangPass& owner = m_preset.passes[static_cast<std::size_t>(pass)];
    Sampler sampler{filter_of(owner.is_linear, m_unspecified), owner.wrap, is_mipmapped};
    if (is_mipmapped)
        sampler.between_levels =
            owner.is_linear.value_or(true) && has_levels(pass) ? Filter::linear : Filter::nearest;
    return sampler;
}

Sampler SlangSampling::of_image(int texture) const {
    const SlangTexture& image = m_preset.textures[static_cast<std::size_t>(texture)];
    return {filter_of(image.is_linear, Filter::linear), image.wrap, image.is_mipmapped};
}
