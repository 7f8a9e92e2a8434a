#pragma once

#include <GL/glcorearb.h>

#include <string>
#include <utility>

// OpenGL 4.1 core functions, found by EGL. Each is X(name without gl, NAME of its pointer type).
// clang-format off
#define PLAYER_GL_FUNCTIONS(X) \
    X(ActiveTexture, ACTIVETEXTURE) X(AttachShader, ATTACHSHADER) X(BindBuffer, BINDBUFFER) \
    X(BindFramebuffer, BINDFRAMEBUFFER) X(BindSampler, BINDSAMPLER) X(BindTexture, BINDTEXTURE) \
    X(BindVertexArray, BINDVERTEXARRAY) X(BlendEquation, BLENDEQUATION) \
    X(BlendFuncSeparate, BLENDFUNCSEPARATE) X(BlitFramebuffer, BLITFRAMEBUFFER) \
    X(BufferData, BUFFERDATA) X(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS) \
    X(ClearBufferfv, CLEARBUFFERFV) X(ClearBufferiv, CLEARBUFFERIV) \
    X(ClearBufferuiv, CLEARBUFFERUIV) X(CompileShader, COMPILESHADER) \
    X(CopyTexSubImage2D, COPYTEXSUBIMAGE2D) X(CreateProgram, CREATEPROGRAM) \
    X(CreateShader, CREATESHADER) X(DeleteBuffers, DELETEBUFFERS) \
    X(DeleteFramebuffers, DELETEFRAMEBUFFERS) X(DeleteProgram, DELETEPROGRAM) \
    X(DeleteSamplers, DELETESAMPLERS) X(DeleteShader, DELETESHADER) \
    X(DeleteTextures, DELETETEXTURES) X(DeleteVertexArrays, DELETEVERTEXARRAYS) \
    X(Disable, DISABLE) X(DrawArrays, DRAWARRAYS) X(DrawArraysInstanced, DRAWARRAYSINSTANCED) \
    X(Enable, ENABLE) X(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY) \
    X(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D) X(GenBuffers, GENBUFFERS) \
    X(GenFramebuffers, GENFRAMEBUFFERS) X(GenSamplers, GENSAMPLERS) X(GenTextures, GENTEXTURES) \
    X(GenVertexArrays, GENVERTEXARRAYS) X(GenerateMipmap, GENERATEMIPMAP) \
    X(GetActiveUniform, GETACTIVEUNIFORM) X(GetAttribLocation, GETATTRIBLOCATION) \
    X(GetError, GETERROR) X(GetProgramInfoLog, GETPROGRAMINFOLOG) X(GetProgramiv, GETPROGRAMIV) \
    X(GetShaderInfoLog, GETSHADERINFOLOG) X(GetShaderiv, GETSHADERIV) \
    X(GetUniformLocation, GETUNIFORMLOCATION) X(LinkProgram, LINKPROGRAM) \
    X(ReadPixels, READPIXELS) X(SamplerParameteri, SAMPLERPARAMETERI) \
    X(ShaderSource, SHADERSOURCE) X(TexImage2D, TEXIMAGE2D) X(TexImage3D, TEXIMAGE3D) \
    X(TexParameteri, TEXPARAMETERI) X(Uniform1fv, UNIFORM1FV) X(Uniform1i, UNIFORM1I) \
    X(Uniform1iv, UNIFORM1IV) X(Uniform1uiv, UNIFORM1UIV) X(Uniform2fv, UNIFORM2FV) \
    X(Uniform2iv, UNIFORM2IV) X(Uniform2uiv, UNIFORM2UIV) X(Uniform3fv, UNIFORM3FV) \
    X(Uniform3iv, UNIFORM3IV) X(Uniform3uiv, UNIFORM3UIV) X(Uniform4fv, UNIFORM4FV) \
    X(Uniform4iv, UNIFORM4IV) X(Uniform4uiv, UNIFORM4UIV) X(UniformMatrix2fv, UNIFORMMATRIX2FV) \
    X(UniformMatrix2x3fv, UNIFORMMATRIX2X3FV) X(UniformMatrix2x4fv, UNIFORMMATRIX2X4FV) \
    X(UniformMatrix3fv, UNIFORMMATRIX3FV) X(UniformMatrix3x2fv, UNIFORMMATRIX3X2FV) \
    X(UniformMatrix3x4fv, UNIFORMMATRIX3X4FV) X(UniformMatrix4fv, UNIFORMMATRIX4FV) \
    X(UniformMatrix4x2fv, UNIFORMMATRIX4X2FV) X(UniformMatrix4x3fv, UNIFORMMATRIX4X3FV) \
    X(UseProgram, USEPROGRAM) X(VertexAttrib3f, VERTEXATTRIB3F) \
    X(VertexAttribDivisor, VERTEXATTRIBDIVISOR) X(VertexAttribPointer, VERTEXATTRIBPOINTER) \
    X(Viewport, VIEWPORT)
// clang-format on

#define PLAYER_GL_DECLARE(name, TYPE) extern PFNGL##TYPE##PROC gl##name;
PLAYER_GL_FUNCTIONS(PLAYER_GL_DECLARE)
#undef PLAYER_GL_DECLARE

/// Makes an OpenGL 4.1 core context current, without a display. Fails if the driver has none.
void open_context();

/// Owns a GL object. `Delete` frees its name.
template <void (*Delete)(GLuint)>
class GlName {
public:
    explicit GlName(GLuint name) : m_name(name) {}
    GlName(GlName&& other) noexcept : m_name(std::exchange(other.m_name, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(m_name, other.m_name);
        return *this;
    }
    ~GlName() {
        if (m_name != 0)
            Delete(m_name);
    }
    GLuint get() const { return m_name; }

private:
    GLuint m_name;
};

inline void delete_texture(GLuint name) {
    glDeleteTextures(1, &name);
}
inline void delete_framebuffer(GLuint name) {
    glDeleteFramebuffers(1, &name);
}
inline void delete_buffer(GLuint name) {
    glDeleteBuffers(1, &name);
}
inline void delete_vertex_array(GLuint name) {
    glDeleteVertexArrays(1, &name);
}
inline void delete_sampler(GLuint name) {
    glDeleteSamplers(1, &name);
}
inline void delete_shader(GLuint name) {
    glDeleteShader(name);
}
inline void delete_program(GLuint name) {
    glDeleteProgram(name);
}
