#pragma once

#include "gpu/objects/texture.h"
#include "graph/programs/frame.h"
#include "model/look/look.h"

#include <vector>

/// The sound textures of a look.
class SoundTextures {
public:
    /// The textures that passes of the look read, with silence.
    static Result<SoundTextures> make(const Look& look);
    /// Updates them to the end of the frame.
    void show(const Frame& frame);

    /// Null if no pass reads it.
    const gpu::Texture* find(const SoundTexture& wanted) const;
    std::vector<SoundTexture> all() const;

private:
    struct Made {
        SoundTexture follows;
        gpu::Texture texture;
    };

    std::vector<Made> m_made;
    std::vector<float> m_levels;
    std::vector<float> m_texels;
};
