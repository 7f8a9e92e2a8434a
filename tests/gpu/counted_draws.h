#pragma once

#include <epoxy/gl.h>

#include <utility>

/// Counts the GL draw and blit calls while it exists, whoever makes them. Only one may exist at a
/// time. libepoxy resolves a function on its first call, so draw something before.
class CountedDraws {
public:
    CountedDraws() {
        s_count = 0;
        s_arrays = std::exchange(epoxy_glDrawArrays, &draw_arrays);
        s_instanced = std::exchange(epoxy_glDrawArraysInstanced, &draw_instanced);
        s_elements = std::exchange(epoxy_glDrawElements, &draw_elements);
        s_blit = std::exchange(epoxy_glBlitFramebuffer, &blit);
    }
    ~CountedDraws() {
        epoxy_glDrawArrays = s_arrays;
        epoxy_glDrawArraysInstanced = s_instanced;
        epoxy_glDrawElements = s_elements;
        epoxy_glBlitFramebuffer = s_blit;
    }
    CountedDraws(const CountedDraws&) = delete;
    CountedDraws& operator=(const CountedDraws&) = delete;

    /// Since the last call.
    static int take() { return std::exchange(s_count, 0); }

private:
    static void draw_arrays(GLenum mode, GLint first, GLsizei count) {
        ++s_count;
        s_arrays(mode, first, count);
    }
    static void draw_instanced(GLenum mode, GLint first, GLsizei count, GLsizei instances) {
        ++s_count;
        s_instanced(mode, first, count, instances);
    }
    static void draw_elements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
        ++s_count;
        s_elements(mode, count, type, indices);
    }
    static void blit(GLint x0, GLint y0, GLint x1, GLint y1, GLint to_x0, GLint to_y0, GLint to_x1,
                     GLint to_y1, GLbitfield mask, GLenum filter) {
        ++s_count;
        s_blit(x0, y0, x1, y1, to_x0, to_y0, to_x1, to_y1, mask, filter);
    }

    inline static int s_count = 0;
    inline static PFNGLDRAWARRAYSPROC s_arrays = nullptr;
    inline static PFNGLDRAWARRAYSINSTANCEDPROC s_instanced = nullptr;
    inline static PFNGLDRAWELEMENTSPROC s_elements = nullptr;
    inline static PFNGLBLITFRAMEBUFFERPROC s_blit = nullptr;
};
