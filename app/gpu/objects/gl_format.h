#pragma once

#include "model/look/format.h"

#include <epoxy/gl.h>

namespace gpu {

/// What GL calls a Format, and the layout in which its texels can be handed over without pixels.
struct GlFormat {
    GLint internal = GL_RGBA16F;
    GLenum layout = GL_RGBA;
    GLenum type = GL_FLOAT;
};

GlFormat gl_format(Format format);

}  // namespace gpu
