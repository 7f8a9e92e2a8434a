#include "gpu/canvas.h"
#include "gpu/draw.h"
#include "gpu/headless.h"
#include "gpu/readback.h"

#include <cstdlib>
#include <thread>

TEST_CASE_FIXTURE(Headless, "a context says who draws and how much") {
    const gpu::Facts& facts = (*context)->facts();
    CHECK_FALSE(facts.renderer.empty());
    CHECK_FALSE(facts.version.empty());
    CHECK(facts.largest_texture >= 16384 / 2);  // OpenGL 4.1 wants 16384, some drivers have less
    CHECK(facts.largest_point_size >= 1.0f);
}

TEST_CASE("a context needs no display") {
    const char* display = std::getenv("DISPLAY");
    const std::string former = display ? display : "";
    unsetenv("DISPLAY");
    CHECK(gpu::Context::headless().has_value());
    if (display)
        setenv("DISPLAY", former.c_str(), 1);
}

TEST_CASE_FIXTURE(Headless, "what a helper thread draws is there for the first one") {
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

TEST_CASE("contexts come and go, also while others live") {
    auto first = gpu::Context::headless();
    REQUIRE(first.has_value());
    for (int i = 0; i < 3; ++i)
        REQUIRE(gpu::Context::headless().has_value());
    (*first)->make_current();
    CHECK(gpu::Canvas::make({1, 1}, Format::rgba8).has_value());
}

TEST_CASE("the error log hears of a mistake") {
    auto context = gpu::Context::headless();
    REQUIRE(context.has_value());
    gpu::ErrorLog log;
    CHECK(log.take().empty());
    gpu::draw_points(-1);
    CHECK(log.take().size() == 1);
    CHECK(log.take().empty());
}
