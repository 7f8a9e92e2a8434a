#include "gpu/objects/draw.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace gpu {

DrawScope::DrawScope() {
    for (const GLenum test : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_SCISSOR_TEST})
        glDisable(test);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_FRAMEBUFFER_SRGB);           // only affects sRGB targets
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);  // as in WebGL, which foreign shaders are written for
    set_blend(Blend::replace);
}

DrawScope::~DrawScope() {
    set_blend(Blend::replace);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_PROGRAM_POINT_SIZE);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glUseProgram(0);
    glBindVertexArray(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

namespace {
constexpr int all_pixels = 1 << 20;  // larger than any row or column
}

void limit_columns(int first, int end) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(first, 0, std::max(end - first, 0), all_pixels);
}

void limit_rows(int first, int end) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, first, all_pixels, std::max(end - first, 0));
}

void lift_limits() {
    glDisable(GL_SCISSOR_TEST);
}

void set_blend(Blend blend) {
    if (blend == Blend::replace) {
        glDisable(GL_BLEND);
        return;
    }
    glEnable(GL_BLEND);
    glBlendEquation(blend == Blend::maximum ? GL_MAX : GL_FUNC_ADD);
    if (blend == Blend::add || blend == Blend::maximum)
        glBlendFunc(GL_ONE, GL_ONE);
    else if (blend == Blend::multiply)
        glBlendFunc(GL_DST_COLOR, GL_ZERO);
    else
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void set_blend_onto() {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
}

bool can_read_own_target() {
    static const bool can = epoxy_has_gl_extension("GL_ARB_texture_barrier");
    return can;
}

void make_own_target_readable() {
    glTextureBarrier();
}

void draw_triangle() {
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void draw_points(int count) {
    glDrawArrays(GL_POINTS, 0, count);
}

void draw_quads(int instances) {
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, instances);
}

void bind_screen(Extent extent) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, extent.width, extent.height);
}

void clear_screen(std::array<float, 4> rgba) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(rgba[0], rgba[1], rgba[2], rgba[3]);
    glClear(GL_COLOR_BUFFER_BIT);
}

void finish() {
    glFinish();
}

}  // namespace gpu
