#include "gpu/debug_names.h"
#include "graph/looks.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>

namespace {
// The labels of all objects of a kind, sorted, each once.
std::vector<std::string> labels(GLenum kind, GLboolean (*is_object)(GLuint)) {
    std::vector<std::string> all;
    for (GLuint id = 1; id < 200; ++id) {
        std::array<char, 64> text{};
        GLsizei length = 0;
        if (!is_object(id))
            continue;
        glGetObjectLabel(kind, id, static_cast<GLsizei>(text.size()), &length, text.data());
        if (length > 0)
            all.emplace_back(text.data(), static_cast<std::size_t>(length));
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

std::vector<std::string> groups;

void GLAPIENTRY note_group(GLenum, GLenum type, GLuint, GLenum, GLsizei length,
                           const GLchar* message, const void*) {
    if (type == GL_DEBUG_TYPE_PUSH_GROUP)
        groups.emplace_back(message, static_cast<std::size_t>(length));
}
}  // namespace

TEST_CASE("textures, framebuffers and programs have the names of their passes") {
    const auto context = gpu::create_headless_context(true);
    REQUIRE(context.has_value());
    const Look look = look_of(
        {counter(),
         pass("show", "uniform sampler2D image;\nvoid main() { color = texture(image, uv); }\n",
              {reads("image", "counter")})});
    Executor executor = executor_of(look);
    executor.draw(frame(1));
    const std::vector<std::string> names{"counter", "show"};
    CHECK(labels(GL_TEXTURE, [](GLuint id) { return glIsTexture(id); }) == names);
    CHECK(labels(GL_FRAMEBUFFER, [](GLuint id) { return glIsFramebuffer(id); }) == names);
    CHECK(labels(GL_PROGRAM, [](GLuint id) { return glIsProgram(id); }) == names);
    CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("the calls of a pass are a debug group") {
    const auto context = gpu::create_headless_context(true);
    REQUIRE(context.has_value());
    Executor executor = executor_of(look_of({counter()}));
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    groups.clear();
    glDebugMessageCallback(note_group, nullptr);
    executor.draw(frame(1));
    glDebugMessageCallback(nullptr, nullptr);
    CHECK(std::ranges::count(groups, "counter") >= 1);
}
