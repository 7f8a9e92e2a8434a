#include "bench/plain_reload.h"

#include "bench/side_by_side.h"
#include "gpu/headless_context.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <chrono>
#include <cstdlib>

namespace bench {

namespace {
void parse(EShLanguage stage, const std::string& text) {
    glslang::TShader shader(stage);
    const char* pieces[] = {text.c_str()};
    shader.setStrings(pieces, 1);
    if (!shader.parse(GetDefaultResources(), 410, false, EShMsgDefault)) {
        fmt::print(stderr, "{}", shader.getInfoLog());
        std::exit(EXIT_FAILURE);
    }
}

GLuint compile(GLenum stage, const std::string& text) {
    const GLuint id = glCreateShader(stage);
    const char* pieces[] = {text.c_str()};
    glShaderSource(id, 1, pieces, nullptr);
    glCompileShader(id);
    return id;
}

GLuint new_texture(GLint format, Extent extent) {
    GLuint id = 0;
    glGenTextures(1, &id);
    glBindTexture(GL_TEXTURE_2D, id);
    glTexImage2D(GL_TEXTURE_2D, 0, format, extent.width, extent.height, 0, GL_RGBA, GL_FLOAT,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return id;
}
}  // namespace

PlainReload::PlainReload(const Executor& of, const ReloadLook& look)
    : m_look(look),
      m_context(gpu::create_headless_context().value()),
      m_vertex(of.programs().generic().passes.back().vertex),
      m_fragment(of.programs().generic().passes.back().fragment),
      m_picture(of.plan().targets.back().extent) {
    gpu::Context* const before = gpu::Context::current();
    m_context->make_current();
    glGenFramebuffers(1, &m_framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    m_target = new_texture(GL_RGBA8, m_picture);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_target, 0);
    glViewport(0, 0, m_picture.width, m_picture.height);
    glGenVertexArrays(1, &m_vertices);
    glBindVertexArray(m_vertices);
    for (GLuint& input : m_inputs)
        input = new_texture(GL_RGBA16F, m_picture);
    for (GLuint i = 0; i < std::size(m_inputs); ++i) {
        glActiveTexture(GL_TEXTURE0 + i);
        glBindTexture(GL_TEXTURE_2D, m_inputs[i]);
    }
    glFinish();
    before->make_current();
}

PlainReload::~PlainReload() = default;  // its objects are deleted with the context

GLuint PlainReload::build(const std::string& fragment) const {
    parse(EShLangVertex, m_vertex);
    parse(EShLangFragment, fragment);
    const GLuint program = glCreateProgram();
    for (const GLuint shader :
         {compile(GL_VERTEX_SHADER, m_vertex), compile(GL_FRAGMENT_SHADER, fragment)}) {
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    GLint is_linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
    if (is_linked == GL_FALSE) {
        fmt::print(stderr, "The plain GL program doesn't link\n");
        std::exit(EXIT_FAILURE);
    }
    return program;
}

// Each sampler reads its own texture.
void PlainReload::use(GLuint program) const {
    glUseProgram(program);
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    GLint unit = 0;
    for (GLint i = 0; i < count; ++i) {
        char name[256];
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, static_cast<GLuint>(i), sizeof name, nullptr, &size, &type,
                           name);
        if (type == GL_SAMPLER_2D)
            glUniform1i(glGetUniformLocation(program, name), unit++);
    }
}

double PlainReload::over_a_frame(int number) {
    gpu::Context* const before = gpu::Context::current();
    m_context->make_current();
    const double start = busy_seconds();
    const GLuint program = build(with_factor(m_fragment, m_look, number));
    use(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
    const double drawn = busy_seconds();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
    const double again = busy_seconds();
    glDeleteProgram(program);
    before->make_current();
    return 1e3 * ((drawn - start) - (again - drawn));
}

double PlainReload::until_linked(int number) {
    gpu::Context* const before = gpu::Context::current();
    m_context->make_current();
    const auto start = std::chrono::steady_clock::now();
    glDeleteProgram(build(with_factor(m_fragment, m_look, number)));
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - start;
    before->make_current();
    return taken.count();
}

}  // namespace bench
