#pragma once

#include "gpu/objects/texture.h"
#include "model/look/look.h"

#include <optional>
#include <vector>

namespace gpu {

void delete_sampler(GLuint id);

/// The sampler used for a texture of the format: integer formats are never filtered.
Sampler usable_sampler(const Sampler& wanted, Format format);

/// Binds textures to units, each with a sampler object; equal samplers share an object.
class Samplers {
public:
    /// Binds with usable_sampler().
    void bind(int unit, const Texture& texture, const Sampler& sampler);
    /// Reads like an incomplete texture.
    void bind_nothing(int unit);
    /// Unbinds all units that were used.
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
