#pragma once

#include "gpu/objects/canvas.h"

#include <map>

/// Cubes made of what passes drew as six faces side by side, +x -x +y -y +z -z, each as wide as the
/// picture is high.
class CubeCopies {
public:
    /// The cube of what the canvas holds now; null where its sides do not fit, or no memory is
    /// left.
    const gpu::Texture* copy_of(const gpu::Canvas& faces, bool is_mipmapped);

private:
    std::map<GLuint, gpu::Texture> m_cubes;  // by the canvas's texture
};
