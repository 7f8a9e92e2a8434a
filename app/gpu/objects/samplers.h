#pragma once

#include "gpu/objects/texture.h"
#include "model/look/look.h"

#include <optional>
#include <vector>

namespace gpu {

void delete_sampler(GLuint id);

/// How a texture of the format is read where `wanted` was asked for: integers without a filter.
Sampler usable_sampler(const Sampler& wanted, Format format);

/// Binds textures to units, each read through a sampler object; one object a kind of sampler.
class Samplers {
public:
    /// As usable_sampler says.
    void bind(int unit, const Texture& texture, const Sampler& sampler);
    /// Reads as an incomplete texture does.
    void bind_nothing(int unit);
    /// Leaves every unit that was used empty.
    void release();

private:
    GLuint object_for(const Sampler& sampler);

    struct Made {
        Sampler sampler;
        Name<delete_sampler> name;
    };
    std::vector<Made> m_made;
    int m_used_units = 0;
};

}  // namespace gpu
