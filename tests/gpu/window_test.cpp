#include "gpu/window.h"

#include "gpu/glx_context.h"

#include <doctest/doctest.h>

#include <cstdlib>

TEST_CASE("without a display, opening a window fails with an error each time") {
    const char* display = std::getenv("DISPLAY");
    const std::string previous = display ? display : "";
    for (const char* absent : {"", ":987"}) {
        setenv("DISPLAY", absent, 1);
        const auto window = gpu::Window::open({"test"});
        REQUIRE_FALSE(window.has_value());
        CHECK(window.error().front().message.starts_with("can't open a window: "));
    }
    if (display)
        setenv("DISPLAY", previous.c_str(), 1);
    else
        unsetenv("DISPLAY");
}

TEST_CASE("without a GLX context there is no shared context") {
    const gpu::GlxHandles nowhere;
    CHECK(gpu::share_through_glx(nowhere, {}) == nullptr);
}
