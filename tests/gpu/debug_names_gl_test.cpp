#include "gpu/debug_names.h"
#include "gpu/headless_context.h"
#include "gpu/objects/canvas.h"
#include "gpu/program.h"

#include <doctest/doctest.h>
#include <epoxy/gl.h>

#include <array>
#include <string>
#include <utility>

namespace {
std::string label_of(GLenum kind, GLuint id) {
    std::array<char, 512> text{};
    GLsizei length = 0;
    glGetObjectLabel(kind, id, static_cast<GLsizei>(text.size()), &length, text.data());
    return {text.data(), static_cast<std::size_t>(length)};
}

/// Counts calls of GL_KHR_debug while it exists.
class CountedNames {
public:
    CountedNames() {
        s_count = 0;
        s_label = std::exchange(epoxy_glObjectLabel, &label);
        s_push = std::exchange(epoxy_glPushDebugGroup, &push);
        s_pop = std::exchange(epoxy_glPopDebugGroup, &pop);
    }
    ~CountedNames() {
        epoxy_glObjectLabel = s_label;
        epoxy_glPushDebugGroup = s_push;
        epoxy_glPopDebugGroup = s_pop;
    }
    CountedNames(const CountedNames&) = delete;
    CountedNames& operator=(const CountedNames&) = delete;

    static int count() { return s_count; }

private:
    static void label(GLenum kind, GLuint id, GLsizei length, const GLchar* text) {
        ++s_count;
        s_label(kind, id, length, text);
    }
    static void push(GLenum source, GLuint id, GLsizei length, const GLchar* text) {
        ++s_count;
        s_push(source, id, length, text);
    }
    static void pop() {
        ++s_count;
        s_pop();
    }

    inline static int s_count = 0;
    inline static PFNGLOBJECTLABELPROC s_label = nullptr;
    inline static PFNGLPUSHDEBUGGROUPPROC s_push = nullptr;
    inline static PFNGLPOPDEBUGGROUPPROC s_pop = nullptr;
};

gpu::Program white() {
    auto program = gpu::Program::build(
        {"a.vert", "#version 410 core\nvoid main() { gl_Position = vec4(0.0); }\n", {}},
        {"a.frag", "#version 410 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n", {}});
    REQUIRE(program.has_value());
    return std::move(*program);
}
}  // namespace

TEST_CASE("names of textures, framebuffers and programs read back in a debug context") {
    const auto context = gpu::create_headless_context(true);
    REQUIRE(context.has_value());
    REQUIRE(gpu::is_debugged());
    const auto canvas = gpu::Canvas::make({4, 4}, Format::rgba8);
    REQUIRE(canvas.has_value());
    const gpu::Program program = white();
    gpu::set_label(*canvas, "heat");
    gpu::set_label(program, std::string(2000, 'x'));
    canvas->bind();
    program.use();
    CHECK(label_of(GL_TEXTURE, canvas->texture().id()) == "heat");
    CHECK(label_of(GL_FRAMEBUFFER, canvas->framebuffer()) == "heat");
    CHECK(label_of(GL_PROGRAM, program.id()) == std::string(255, 'x'));
    GLint depth = 0;
    {
        const gpu::DebugGroup outer("frame");
        const gpu::DebugGroup inner("heat");
        glGetIntegerv(GL_DEBUG_GROUP_STACK_DEPTH, &depth);
        CHECK(depth == 3);  // with the default group
    }
    glGetIntegerv(GL_DEBUG_GROUP_STACK_DEPTH, &depth);
    CHECK(depth == 1);
    CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("a context that shares with a debug context is one too") {
    const auto context = gpu::create_headless_context(true);
    REQUIRE(context.has_value());
    const auto other = gpu::Context::shared_with(**context);
    REQUIRE(other.has_value());
    const gpu::ContextScope scope(other->get());
    CHECK(gpu::is_debugged());
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    CHECK((flags & GL_CONTEXT_FLAG_DEBUG_BIT) != 0);
}

TEST_CASE("without a debugger, names make no GL call") {
    const auto context = gpu::create_headless_context();
    REQUIRE(context.has_value());
    REQUIRE_FALSE(gpu::is_debugged());
    const auto canvas = gpu::Canvas::make({4, 4}, Format::rgba8);
    REQUIRE(canvas.has_value());
    const gpu::Program program = white();
    const CountedNames counted;
    gpu::set_label(*canvas, "heat");
    gpu::set_label(program, "heat");
    const gpu::DebugGroup group("heat");
    CHECK(CountedNames::count() == 0);
}
