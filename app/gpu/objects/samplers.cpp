#include "gpu/objects/samplers.h"

#include <algorithm>

namespace gpu {

void delete_sampler(GLuint id) {
    glDeleteSamplers(1, &id);
}

namespace {
GLint gl_wrap(Wrap wrap) {
    switch (wrap) {
        case Wrap::edge:
            return GL_CLAMP_TO_EDGE;
        case Wrap::border:
            return GL_CLAMP_TO_BORDER;  // the default border is transparent black
        case Wrap::repeat:
            return GL_REPEAT;
        case Wrap::mirror:
            return GL_MIRRORED_REPEAT;
    }
    return GL_CLAMP_TO_EDGE;
}

GLuint new_sampler(const Sampler& sampler) {
    const bool is_linear = sampler.filter == Filter::linear;
    const GLint single = is_linear ? GL_LINEAR : GL_NEAREST;
    const bool blends_levels = sampler.between_levels.value_or(sampler.filter) == Filter::linear;
    const GLint mipmap =
        is_linear ? (blends_levels ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_NEAREST)
                  : (blends_levels ? GL_NEAREST_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST);
    GLuint id = 0;
    glGenSamplers(1, &id);
    glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, sampler.mipmap ? mipmap : single);
    glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, single);
    glSamplerParameteri(id, GL_TEXTURE_WRAP_S, gl_wrap(sampler.wrap));
    glSamplerParameteri(id, GL_TEXTURE_WRAP_T, gl_wrap(sampler.wrap));
    glSamplerParameteri(id, GL_TEXTURE_WRAP_R, gl_wrap(sampler.wrap));
    return id;
}
}  // namespace

Sampler usable_sampler(const Sampler& wanted, Format format) {
    return info_of(format).is_integer ? Sampler{Filter::nearest, wanted.wrap, false} : wanted;
}

GLuint Samplers::object_for(const Sampler& sampler) {
    for (const Made& made : m_made)
        if (made.sampler == sampler)
            return made.name.get();
    m_made.push_back({sampler, Name<delete_sampler>(new_sampler(sampler))});
    return m_made.back().name.get();
}

void Samplers::bind(int unit, const Texture& texture, const Sampler& sampler) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(texture.target(), texture.id());
    glBindSampler(static_cast<GLuint>(unit), object_for(usable_sampler(sampler, texture.format())));
    m_used_units = std::max(m_used_units, unit + 1);
}

void Samplers::bind_nothing(int unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    for (const GLenum target : {GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_3D})
        glBindTexture(target, 0);
    glBindSampler(static_cast<GLuint>(unit), 0);
}

void Samplers::release() {
    for (int unit = 0; unit < m_used_units; ++unit)
        bind_nothing(unit);
    glActiveTexture(GL_TEXTURE0);
    m_used_units = 0;
}

}  // namespace gpu
