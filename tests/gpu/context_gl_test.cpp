#include "gpu/headless.h"
#include "gpu/objects/canvas.h"
#include "gpu/objects/draw.h"
#include "gpu/objects/readback.h"
#include "gpu/program.h"

#include <epoxy/gl.h>

#include <cstdlib>
#include <optional>
#include <thread>

TEST_CASE_FIXTURE(Headless, "a context reports its renderer and limits") {
    const gpu::DriverInfo& info = (*context)->info();
    CHECK_FALSE(info.renderer.empty());
    CHECK_FALSE(info.version.empty());
    CHECK(info.largest_texture >= 16384 / 2);  // GL 4.1 requires 16384; some drivers have less
    CHECK(info.largest_point_size >= 1.0f);
}

TEST_CASE("a context needs no display") {
    const char* display = std::getenv("DISPLAY");
    const std::string previous = display ? display : "";
    unsetenv("DISPLAY");
    CHECK(gpu::create_headless_context().has_value());
    if (display)
        setenv("DISPLAY", previous.c_str(), 1);
}

TEST_CASE_FIXTURE(
    Headless, "results of a shared context on another thread are visible in the first context") {
    auto helper = gpu::Context::shared_with(**context);
    REQUIRE(helper.has_value());
    auto texture = gpu::Texture::make({2, 2}, Format::rgba32f);
    REQUIRE(texture.has_value());
    std::thread([&] {
        (*helper)->make_current();
        texture->upload(std::vector<float>(16, 0.5f));
        gpu::finish();
        (*helper)->release();
    }).join();
    CHECK(gpu::read_pixel(*texture, 1, 1) == std::array<float, 4>{0.5f, 0.5f, 0.5f, 0.5f});
}

TEST_CASE_FIXTURE(Headless,
                  "a scope makes another context current, and its drawing is visible afterwards") {
    auto other = gpu::Context::shared_with(**context);
    REQUIRE(other.has_value());
    std::optional<gpu::Canvas> canvas;
    {
        const gpu::ContextScope scope(other->get());
        CHECK(gpu::Context::current() == other->get());
        canvas.emplace(gpu::Canvas::make({2, 2}, Format::rgba32f).value());
        const gpu::ContextScope same(other->get());
        canvas->clear({0.25f, 0.5f, 0.75f, 1.0f});
    }
    CHECK(gpu::Context::current() == context->get());
    CHECK(gpu::read_pixel(canvas->texture(), 1, 1) ==
          std::array<float, 4>{0.25f, 0.5f, 0.75f, 1.0f});
    const gpu::ContextScope scope(other->get());
    canvas.reset();
}

TEST_CASE_FIXTURE(Headless, "a scope without a context changes nothing") {
    const gpu::ContextScope scope(nullptr);
    CHECK(gpu::Context::current() == context->get());
}

TEST_CASE_FIXTURE(Headless,
                  "a program is deleted in its own context, whichever thread releases it last") {
    auto made = gpu::Context::shared_with(**context);
    REQUIRE(made.has_value());
    const std::shared_ptr<gpu::Context> look_context = std::move(*made);
    Stage vertex;
    vertex.text = "#version 410 core\nvoid main() { gl_Position = vec4(0.0); }\n";
    Stage fragment;
    fragment.text = "#version 410 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n";
    auto program = gpu::destroyed_in(look_context, gpu::Program::build(vertex, fragment).value());
    program->use();
    GLint id = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &id);
    glUseProgram(0);
    program.reset();
    CHECK(glIsProgram(static_cast<GLuint>(id)));
    { const gpu::ContextScope scope(look_context.get()); }
    CHECK_FALSE(glIsProgram(static_cast<GLuint>(id)));
    CHECK(look_context.use_count() == 1);
}

TEST_CASE("contexts can be created and destroyed while others exist") {
    auto first = gpu::create_headless_context();
    REQUIRE(first.has_value());
    for (int i = 0; i < 3; ++i)
        REQUIRE(gpu::create_headless_context().has_value());
    (*first)->make_current();
    CHECK(gpu::Canvas::make({1, 1}, Format::rgba8).has_value());
}

TEST_CASE("the error log records a GL error") {
    auto context = gpu::create_headless_context();
    REQUIRE(context.has_value());
    gpu::ErrorLog log;
    CHECK(log.take().empty());
    gpu::draw_points(-1);
    CHECK(log.take().size() == 1);
    CHECK(log.take().empty());
}
