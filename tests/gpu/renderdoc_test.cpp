#include "gpu/renderdoc.h"

#include <doctest/doctest.h>

#include <dlfcn.h>

// The fake library has RenderDoc's soname and counts captures.
TEST_CASE("RenderDoc is found only when its library is loaded, and captures the next frame") {
    REQUIRE_FALSE(gpu::has_renderdoc());
    gpu::capture_next_frame();  // does nothing

    void* const library = dlopen(FAKE_RENDERDOC, RTLD_NOW);
    REQUIRE(library != nullptr);
    const auto captures = reinterpret_cast<int (*)()>(dlsym(library, "fake_captures"));
    REQUIRE((captures != nullptr));
    CHECK(gpu::has_renderdoc());
    CHECK(captures() == 0);
    gpu::capture_next_frame();
    CHECK(captures() == 1);
    dlclose(library);
    CHECK_FALSE(gpu::has_renderdoc());
}
