#include "lab/corpus.h"

#include <doctest/doctest.h>

#include <cstdlib>

TEST_CASE("of the public corpus of Shadertoy's shaders 99 in 100 are translated") {
    constexpr int sample = 1000;
    constexpr int seed = 11;
    const char* folder = std::getenv("AFTERGLOW_SHADERTOY_DIR");
    if (!folder) {
        MESSAGE("skipped: AFTERGLOW_SHADERTOY_DIR names no folder of shaders of Shadertoy");
        return;
    }
    const auto roots = find_roots({});
    REQUIRE(roots.has_value());
    const Library library(*roots);
    const auto files = corpus_files(folder, {"", sample, seed});
    REQUIRE(files.size() == sample);
    std::size_t compiled = 0;
    for (const auto& file : files)
        compiled += try_look(file, {.frames = 0}, library).is_compiled ? 1 : 0;
    CHECK(compiled * 100 >= files.size() * 99);
}
