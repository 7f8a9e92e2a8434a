#pragma once

#include "gpu/objects/texture.h"
#include "graph/programs/frame.h"
#include "model/look/look.h"

#include <vector>

/// The textures of a look that follow the sound.
class SoundTextures {
public:
    /// Those that some pass of the look reads, silent.
    static Result<SoundTextures> make(const Look& look);
    /// As they are at the frame's end.
    void show(const Frame& frame);

    /// Null where no pass reads it.
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
