#include "formats/slang/controls.h"
#include "formats/slang/expand.h"
#include "formats/slang/shader.h"
#include "glsl/compile/translate.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace fs = std::filesystem;

namespace {
// Counts over all presets of libretro's slang-shaders, commit 1bce10f.
struct Counts {
    int presets = 0;
    int values_only = 0;
    std::array<int, 7> by_passes{};    // 1, 2-3, 4-7, 8-15, 16-31, 32-47, more
    std::map<Wrap, int> wraps;         // presets with a pass that sets it
    std::array<int, 4> by_textures{};  // 1, 2-7, 8-18, more
    int with_mipmaps = 0;
    int with_float = 0;
    int with_srgb = 0;
    int with_frame_count_mod = 0;
    int last_scaled = 0;
    int without_filter = 0;
    std::vector<std::size_t> parameters;  // per preset
    std::size_t max_lines = 0;
    std::set<std::string> shaders;
    std::set<std::string> broken_shaders;
    int compiled = 0;
};

std::size_t lines_of(const fs::path& shader, SlangFiles& files) {
    std::size_t lines = 0;
    if (const auto pieces = expand_slang(shader, files))
        for (const SlangPiece& piece : *pieces)
            lines += piece.line_count;
    return lines;
}

void count_passes(const SlangPreset& preset, Counts& counts) {
    constexpr std::array<std::size_t, 7> minimum{1, 2, 4, 8, 16, 32, 48};
    const auto above = std::ranges::upper_bound(minimum, preset.passes.size());
    ++counts.by_passes[static_cast<std::size_t>(above - minimum.begin() - 1)];
    const auto any = [&](auto has) { return std::ranges::any_of(preset.passes, has) ? 1 : 0; };
    for (const Wrap wrap : {Wrap::edge, Wrap::mirror, Wrap::repeat})
        counts.wraps[wrap] += any([&](const SlangPass& pass) { return pass.wrap == wrap; });
    counts.with_mipmaps += any([](const SlangPass& pass) { return pass.reads_mipmaps; });
    counts.with_float += any([](const SlangPass& pass) { return pass.is_float; });
    counts.with_srgb += any([](const SlangPass& pass) { return pass.is_srgb; });
    counts.with_frame_count_mod +=
        any([](const SlangPass& pass) { return pass.frame_count_mod > 0; });
    counts.without_filter += any([](const SlangPass& pass) { return !pass.is_linear; });
    counts.last_scaled += preset.passes.back().scale ? 1 : 0;
}

void count_shaders(const SlangPreset& preset, SlangFiles& files, Counts& counts) {
    SlangParameters all;
    for (const SlangPass& pass : preset.passes) {
        const bool is_new = counts.shaders.insert(pass.shader.string()).second;
        const auto shader = read_slang_shader(pass.shader, files);
        if (!shader) {
            counts.broken_shaders.insert(to_string(shader.error()));
            continue;
        }
        if (is_new) {
            counts.max_lines = std::max(counts.max_lines, lines_of(pass.shader, files));
            const auto translated = translate_from_vulkan(shader->vertex, shader->fragment);
            CHECK_MESSAGE(translated.has_value(), problems_of(translated));
            counts.compiled += translated ? 1 : 0;
        }
        all.insert(all.end(), shader->parameters.begin(), shader->parameters.end());
    }
    Diagnostics warnings;
    const SlangParameters unique = unique_slang_parameters(all, warnings);
    counts.parameters.push_back(unique.size());
    const SlangControls controls = slang_controls(unique, preset.values);
    CHECK(controls.parameters.size() <= unique.size());
}

void count(const fs::path& file, Counts& counts) {
    SlangFiles files;
    const auto preset = read_slang_preset(file, files);
    if (!preset) {
        const std::string& said = preset.error().front().message;
        CHECK_MESSAGE(said.starts_with("this preset contains values but no passes"),
                      to_string(preset.error()));
        ++counts.values_only;
        return;
    }
    ++counts.presets;
    count_passes(*preset, counts);
    const std::size_t textures = preset->textures.size();
    if (textures > 0)
        ++counts.by_textures[textures == 1 ? 0 : textures < 8 ? 1 : textures < 19 ? 2 : 3];
    count_shaders(*preset, files, counts);
}
}  // namespace

TEST_CASE("the public corpus of slang presets is read as it was counted") {
    const char* folder = std::getenv("AFTERGLOW_SLANG_DIR");
    if (!folder) {
        MESSAGE("skipped: AFTERGLOW_SLANG_DIR does not name a copy of libretro's slang-shaders");
        return;
    }
    Counts counts;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".slangp")
            count(entry.path(), counts);
    CHECK(counts.presets == 2541);
    CHECK(counts.values_only == 6);
    CHECK(counts.by_passes == std::array{368, 261, 239, 381, 994, 263, 35});
    CHECK(counts.wraps[Wrap::edge] == 644);
    CHECK(counts.wraps[Wrap::mirror] == 237);
    CHECK(counts.wraps[Wrap::repeat] == 3);
    CHECK(counts.by_textures == std::array{720, 532, 3, 555});
    CHECK(counts.with_mipmaps == 1532);
    CHECK(counts.with_float == 1089);
    CHECK(counts.with_srgb == 839);
    CHECK(counts.with_frame_count_mod == 209);
    CHECK(counts.last_scaled == 1458);
    CHECK(counts.without_filter == 1040);
    CHECK(counts.shaders.size() == 1338);
    CHECK(counts.broken_shaders.empty());
    CHECK(counts.compiled == 1338);
    // crt-royale with its 36 includes expanded.
    CHECK(counts.max_lines == 15586);
    std::ranges::sort(counts.parameters);
    REQUIRE_FALSE(counts.parameters.empty());
    CHECK(counts.parameters[counts.parameters.size() / 2] == 195);
    CHECK(counts.parameters.back() == 994);
    CHECK(std::ranges::count(counts.parameters, std::size_t{0}) == 111);
}
