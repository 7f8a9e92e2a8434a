#include "lab/offline/offline.h"
#include "lab/small_lab.h"
#include "lab/storage/shader_cache.h"

namespace fs = std::filesystem;

namespace {
/// A second run of the program: the number of programs of the small look that it compiled.
std::size_t compiled_programs(const Roots& roots) {
    auto prepared = prepare({.look = "small"}, Library(roots));
    REQUIRE(prepared.has_value());
    auto offline = Offline::create(std::move(*prepared), {8, 8}, 60.0);
    REQUIRE(offline.has_value());
    CHECK(offline->picture_after(3).pixels[0] == 3.0f);  // the look counts frames
    std::size_t compiled = 0;
    for (const PassProgram& pass : offline->executor().programs().generic().passes)
        compiled += pass.program->is_restored() ? 0U : 1U;
    return compiled;
}
}  // namespace

TEST_CASE("a look that was drawn before is not compiled again, even after a restart") {
    SmallLab small;
    Roots roots = small.roots();
    roots.cache = small.folder() / "cache";
    CHECK(compiled_programs(roots) == 2);
    CHECK(compiled_programs(roots) == 0);
    small.write("gain.glsl", "uniform float gain = 1.0;  // @range 0 4\n");  // in the second pass
    CHECK(compiled_programs(roots) == 1);
}

TEST_CASE("without a cache folder everything is compiled and nothing is written") {
    SmallLab small;
    const Roots& roots = small.roots();
    REQUIRE(roots.cache.empty());
    CHECK(shader_cache(roots) == nullptr);
    CHECK(compiled_programs(roots) == 2);
    CHECK(compiled_programs(roots) == 2);
}
