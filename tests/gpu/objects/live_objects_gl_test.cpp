#include "gpu/headless.h"
#include "gpu/objects/live_objects.h"
#include "gpu/objects/texture.h"

TEST_CASE_FIXTURE(Headless, "GL objects are counted by kind, until they are deleted") {
    const auto before = gpu::live_objects();
    {
        const auto first = gpu::Texture::make({2, 2}, Format::rgba8, false);
        const auto second = gpu::Texture::make({2, 2}, Format::rgba8, false);
        auto now = gpu::live_objects();
        CHECK(now["textures"] - before.at("textures") == 2);
        now["textures"] = before.at("textures");
        CHECK(now == before);
    }
    CHECK(gpu::live_objects() == before);
}
