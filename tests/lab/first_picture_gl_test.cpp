// What is drawn before the first picture of a window that shows nothing yet.
#include "lab/reload/reloader.h"
#include "lab/small_lab.h"
#include "lab/storage/kept_shaders.h"

namespace {
/// A start of the program: what its reloader has made of the small look.
LoadedRequest opened(const Roots& roots, bool expects_light_frames) {
    auto context = gpu::Context::headless();
    REQUIRE(context.has_value());
    std::optional<LoadedRequest> loaded;
    {
        Reloader reloader(nullptr, **context, roots);
        if (expects_light_frames)
            reloader.expect_light_frames();
        reloader.open({roots.program / "shaders" / "small", {}, {}});
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
        while (!loaded && std::chrono::steady_clock::now() < end) {
            loaded = reloader.take_finished();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        REQUIRE(loaded.has_value());
        CHECK(loaded->is_warm);
        CHECK(loaded->executor != nullptr);
        loaded->executor.reset();
        loaded->programs.reset();
    }
    return std::move(*loaded);
}
}  // namespace

TEST_CASE("the first draws are spared where frames are light and the driver kept all programs") {
    SmallLab small;
    Roots roots = small.roots();
    roots.cache = small.folder() / "cache";
    CHECK_FALSE(opened(roots, true).is_spared_first_draws);  // nothing is kept yet
    CHECK_FALSE(opened(roots, false).is_spared_first_draws);
    CHECK(opened(roots, true).is_spared_first_draws);
    small.write("gain.glsl", "uniform float gain = 1.0;  // @range 0 4\n");  // of the second pass
    CHECK_FALSE(opened(roots, true).is_spared_first_draws);
}
