#pragma once

#include "model/look/format.h"

#include <epoxy/gl.h>

namespace gpu {

/// The GL internal format of a Format, and a valid layout and type for uploads without pixels.
struct GlFormat {
    GLint internal = GL_RGBA16F;
    GLenum layout = GL_RGBA;
    GLenum type = GL_FLOAT;
};

GlFormat gl_format(Format format);

}  // namespace gpu
