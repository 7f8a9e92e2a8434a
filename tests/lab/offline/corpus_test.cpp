#include "lab/offline/corpus.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>

namespace {
std::vector<std::string> sampled_names(const TemporaryFolder& folder, int seed) {
    std::vector<std::string> names;
    for (const auto& file : corpus_files(folder.path(), {"", 5, seed}))
        names.push_back(file.filename().string());
    return names;
}
}  // namespace

TEST_CASE("a seed samples the same files of a folder at any location") {
    const TemporaryFolder here;
    const TemporaryFolder there;
    for (const TemporaryFolder* folder : {&here, &there})
        for (int i = 0; i < 30; ++i)
            folder->write(fmt::format("{}.slangp", i), "shaders = 1\n");
    const std::vector<std::string> first = sampled_names(here, 1);
    CHECK(first.size() == 5);
    CHECK(sampled_names(there, 1) == first);
    CHECK(sampled_names(here, 2) != first);
}

TEST_CASE("each look of a folder is tried once, by its main file") {
    const TemporaryFolder folder;
    const auto names = [&] {
        std::vector<std::string> found;
        for (const auto& file : corpus_files(folder.path(), {}))
            found.push_back(file.filename().string());
        return found;
    };
    const char* const pass = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n";
    folder.write("waves/Image.glsl", pass);
    folder.write("waves/BufferA.glsl", pass);
    folder.write("waves/Common.glsl", "float a;\n");
    folder.write("alone.txt", pass);
    folder.write("notes.txt", "of a person\n");
    folder.write("one.slang", "#version 450\n");
    CHECK(names() == std::vector<std::string>{"alone.txt", "one.slang", "Image.glsl"});
    folder.write("one.slangp", "shaders = 1\nshader0 = one.slang\n");
    CHECK(names() == std::vector<std::string>{"alone.txt", "one.slangp", "Image.glsl"});
}

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
