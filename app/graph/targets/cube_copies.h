#pragma once

#include "gpu/objects/canvas.h"

#include <map>

/// Cube maps of passes that draw six faces side by side, +x -x +y -y +z -z. Each face is as wide as
/// the picture is high.
class CubeCopies {
public:
    /// The cube map of the canvas's current picture; null if its sides do not fit or memory is
    /// exhausted.
    const gpu::Texture* copy_of(const gpu::Canvas& faces, bool is_mipmapped);

private:
    std::map<GLuint, gpu::Texture> m_cubes;  // by the canvas's texture
};
