#include "gpu/objects/live_objects.h"

#include <epoxy/gl.h>

namespace gpu {

namespace {
// Programs and shaders share their names.
template <class IsObject>
int count(const IsObject& is_object) {
    constexpr GLuint most_missing = 256;
    int found = 0;
    for (GLuint name = 1, missing = 0; missing < most_missing; ++name) {
        const bool is_found = is_object(name) != GL_FALSE;
        found += is_found ? 1 : 0;
        missing = is_found ? 0 : missing + 1;
    }
    return found;
}
}  // namespace

std::map<std::string, int> live_objects() {
    return {{"textures", count([](GLuint name) { return glIsTexture(name); })},
            {"buffers", count([](GLuint name) { return glIsBuffer(name); })},
            {"framebuffers", count([](GLuint name) { return glIsFramebuffer(name); })},
            {"vertex_arrays", count([](GLuint name) { return glIsVertexArray(name); })},
            {"samplers", count([](GLuint name) { return glIsSampler(name); })},
            {"queries", count([](GLuint name) { return glIsQuery(name); })},
            {"shaders", count([](GLuint name) { return glIsShader(name); })},
            {"programs", count([](GLuint name) { return glIsProgram(name); })}};
}

}  // namespace gpu
