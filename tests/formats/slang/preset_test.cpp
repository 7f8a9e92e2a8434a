#include "formats/slang/preset.h"

#include "formats/slang/slang_folder.h"
#include "problems_of.h"

#include <fmt/format.h>

namespace {
SlangPreset read(SlangFolder& folder, const std::string& text) {
    const auto preset = folder.preset_of(text);
    REQUIRE_MESSAGE(preset.has_value(), problems_of(preset));
    return *preset;
}

const std::string one_pass = "shaders = 1\nshader0 = a.slang\n";

// The scale of the only pass, such as "source 1 viewport 0.5"; "none": no scale.
std::string scale_with(const std::string& lines) {
    SlangFolder folder;
    const SlangPreset preset = read(folder, one_pass + lines);
    if (!preset.passes[0].scale)
        return "none";
    const auto side = [&](std::size_t i) {
        const SlangScale& scale = (*preset.passes[0].scale)[i];
        const std::array<std::string, 4> words{"source", "viewport", "absolute", "original"};
        return fmt::format("{} {}", words[static_cast<std::size_t>(scale.by)], scale.factor);
    };
    return side(0) + " " + side(1);
}
}  // namespace

TEST_CASE("a pass without settings has the defaults") {
    SlangFolder folder;
    const SlangPreset preset = read(folder, one_pass);
    REQUIRE(preset.passes.size() == 1);
    const SlangPass& pass = preset.passes[0];
    CHECK(pass.shader == folder / "a.slang");
    CHECK(pass.declared == Location{folder / "a.slangp", 2});
    CHECK_FALSE(pass.is_linear.has_value());
    CHECK(pass.wrap == Wrap::border);
    CHECK(pass.frame_count_mod == 0);
    CHECK_FALSE(pass.is_srgb);
    CHECK_FALSE(pass.is_float);
    CHECK_FALSE(pass.reads_mipmaps);
    CHECK(pass.alias.empty());
    CHECK_FALSE(pass.scale.has_value());
    CHECK(preset.textures.empty());
    CHECK(preset.values.empty());
    CHECK(preset.warnings.empty());
}

TEST_CASE("the keys of a pass apply only to that pass") {
    SlangFolder folder;
    const SlangPreset preset = read(
        folder,
        "shaders = \"2\"\nshader0 = a.slang\nshader1 = \"../up/b c.slang\"\nfilter_linear1 = true\n"
        "wrap_mode1 = mirrored_repeat\nframe_count_mod1 = 100\nsrgb_framebuffer1 = true\n"
        "float_framebuffer1 = 1\nmipmap_input1 = true\nalias1 = Glow\nfilter_linear0 = false\n"
        "repeat_mode0 = clamp_to_edge\nfeedback_pass = 0\n");
    REQUIRE(preset.passes.size() == 2);
    CHECK(preset.passes[0].is_linear == false);
    CHECK(preset.passes[0].wrap == Wrap::edge);
    CHECK(preset.passes[0].alias.empty());
    const SlangPass& pass = preset.passes[1];
    CHECK(pass.shader == (folder / "..").lexically_normal() / "up/b c.slang");
    CHECK(pass.is_linear == true);
    CHECK(pass.wrap == Wrap::mirror);
    CHECK(pass.frame_count_mod == 100);
    CHECK(pass.is_srgb);
    CHECK(pass.is_float);
    CHECK(pass.reads_mipmaps);
    CHECK(pass.alias == "Glow");
    CHECK(preset.values.empty());
    CHECK(preset.warnings.empty());
}

TEST_CASE("a preset has 1 to 64 passes, in any number format") {
    SlangFolder folder;
    const auto with_count = [&](const std::string& count) {
        std::string text = "shaders = " + count + "\n";
        for (int i = 0; i < 65; ++i)
            text += fmt::format("shader{} = a.slang\n", i);
        return folder.preset_of(text);
    };
    CHECK(with_count("2.0;")->passes.size() == 2);
    CHECK(with_count("64")->passes.size() == 64);
    for (const char* count : {"0", "65", "-1", "many", "1e99"})
        CHECK(folder.refusal(with_count(count)) ==
              fmt::format(
                  "a.slangp:1: error: 'shaders' must be a number of passes from 1 to 64, got '{}'",
                  count));
}

TEST_CASE("every pass without a shader is reported") {
    SlangFolder folder;
    CHECK(folder.refusal(folder.preset_of("\nshaders = 3\nshader0 = a.slang\nshader2 = \"\"\n")) ==
          "a.slangp:2: error: pass 1 of 3 has no shader; 'shader1' is missing\n"
          "a.slangp:4: error: pass 2 of 3 has no shader; 'shader2' is missing");
}

TEST_CASE("an unknown wrap mode is reported and read as border") {
    SlangFolder folder;
    const SlangPreset preset = read(folder, one_pass + "wrap_mode0 = clamp\n");
    CHECK(preset.passes[0].wrap == Wrap::border);
    CHECK(folder.told(preset.warnings) ==
          "a.slangp:3: warning: 'wrap_mode0' must be clamp_to_border, clamp_to_edge, repeat or "
          "mirrored_repeat, got 'clamp'; clamp_to_border is used");
    CHECK(read(folder, one_pass + "wrap_mode0 = repeat\n").passes[0].wrap == Wrap::repeat);
}

TEST_CASE("a pass without scale_type has no scale") {
    CHECK(scale_with("") == "none");
    CHECK(scale_with("scale0 = 2\n") == "none");
    CHECK(scale_with("scale_x0 = 2\n") == "none");
}

TEST_CASE("one scale_type scales both sides, the other one by the source") {
    CHECK(scale_with("scale_type0 = viewport\n") == "viewport 1 viewport 1");
    CHECK(scale_with("scale_type_x0 = viewport\nscale_x0 = 0.5\n") == "viewport 0.5 source 1");
    CHECK(scale_with("scale_type_y0 = original\nscale_y0 = 3\n") == "source 1 original 3");
}

TEST_CASE("a scale for both sides overrides those of one side") {
    CHECK(scale_with(
              "scale_type0 = source\nscale_type_x0 = viewport\nscale_x0 = 2\nscale_y0 = 3\n") ==
          "source 2 source 3");
    CHECK(scale_with("scale_type_x0 = viewport\nscale_type_y0 = source\nscale0 = 0.25\n"
                     "scale_x0 = 2\n") == "viewport 0.25 source 0.25");
}

TEST_CASE("an absolute scale is in whole pixels") {
    CHECK(scale_with("scale_type0 = absolute\nscale_x0 = 320\nscale_y0 = 240.9\n") ==
          "absolute 320 absolute 240");
}

TEST_CASE("an unknown scale_type is an error at its line") {
    SlangFolder folder;
    CHECK(folder.refusal(folder.preset_of(one_pass + "scale_type_y0 = wide\n")) ==
          "a.slangp:3: error: 'scale_type_y0' must be source, viewport, absolute or original, got "
          "'wide'");
}

TEST_CASE("an invalid scale is read as 0 with a warning") {
    SlangFolder folder;
    CHECK(scale_with("scale_type0 = source\nscale0 = 0'.000000\n") == "source 0 source 0");
    const SlangPreset preset =
        read(folder, one_pass + "scale_type_x0 = source\nscale_x0 = double\n");
    CHECK((*preset.passes[0].scale)[0].factor == 0.0);
    CHECK(folder.told(preset.warnings) ==
          "a.slangp:4: warning: 'scale_x0' must be a number, got 'double'; 0 is used");
}

TEST_CASE("textures keep the order of their list and have their own settings") {
    SlangFolder folder;
    const SlangPreset preset =
        read(folder, one_pass +
                         "textures = \"one; two;\"\ntwo = ..\\lut\\two.png\ntwo_linear = false\n"
                         "two_mipmap = true\ntwo_wrap_mode = repeat\none = one.png\n"
                         "three_linear = 1\nthree_wrap_mode = 2\n");
    REQUIRE(preset.textures.size() == 2);
    CHECK(preset.textures[0].name == "one");
    CHECK(preset.textures[0].file == folder / "one.png");
    CHECK_FALSE(preset.textures[0].is_linear.has_value());
    CHECK(preset.textures[0].wrap == Wrap::border);
    CHECK_FALSE(preset.textures[0].is_mipmapped);
    const SlangTexture& two = preset.textures[1];
    CHECK(two.file == (folder / "../lut/two.png").lexically_normal());
    CHECK(two.is_linear == false);
    CHECK(two.wrap == Wrap::repeat);
    CHECK(two.is_mipmapped);
    CHECK(two.declared == Location{folder / "a.slangp", 4});
    // These keys belong to no texture, so they are values.
    CHECK(preset.values.at("three_linear").number == 1.0);
    CHECK(preset.values.at("three_wrap_mode").number == 2.0);
    CHECK(preset.values.size() == 2);
    CHECK(preset.warnings.empty());
}

TEST_CASE("a texture without a path keeps its index and gives a warning") {
    SlangFolder folder;
    const SlangPreset preset = read(folder, one_pass + "textures = \"a;b\"\nb = b.png\n");
    REQUIRE(preset.textures.size() == 2);
    CHECK(preset.textures[0].file.empty());
    CHECK(folder.told(preset.warnings) ==
          "a.slangp:3: warning: texture 'a' has no path; 'a = file' is missing");
}

TEST_CASE("a preset has at most 64 textures") {
    SlangFolder folder;
    std::string names;
    for (int i = 0; i < 64; ++i)
        names += fmt::format("t{};", i);
    CHECK(read(folder, one_pass + "textures = \"" + names + "\"\n").textures.size() == 64);
    CHECK(folder.refusal(folder.preset_of(one_pass + "textures = \"" + names + "last\"\n")) ==
          "a.slangp:3: error: the preset has 65 textures; the limit is 64");
}

TEST_CASE("every other key with a number is a value, whether or not listed in 'parameters'") {
    SlangFolder folder;
    const SlangPreset preset =
        read(folder, one_pass +
                         "parameters = \"a;b\"\na = 0.25\nodd-name = -3;\nscale = 2\nshader = 1\n"
                         "b = wide\nnowhere = ../x.png\n");
    CHECK(preset.values.size() == 4);
    CHECK(preset.values.at("a").number == 0.25);
    CHECK(preset.values.at("a").declared == Location{folder / "a.slangp", 4});
    CHECK(preset.values.at("odd-name").number == -3.0);
    CHECK(preset.values.at("scale").number == 2.0);
    CHECK(preset.values.at("shader").number == 1.0);
    CHECK(folder.told(preset.warnings) ==
          "a.slangp:8: warning: 'b' must be a number, got 'wide'; it is ignored");
}

TEST_CASE("every file of a preset is watched, missing ones too") {
    SlangFolder folder;
    read(folder, one_pass + "textures = lut\nlut = lut.png\n");
    CHECK(folder.has_seen("a.slangp"));
    CHECK(folder.has_seen("a.slang"));
    CHECK(folder.has_seen("lut.png"));
    CHECK(folder.refusal(folder.preset("gone.slangp")) == "gone.slangp: error: file not found");
    CHECK(folder.has_seen("gone.slangp"));
}

TEST_CASE("a single shader is a preset with one pass at the size of the view") {
    const SlangPreset preset = slang_preset_of("x/crt.slang");
    REQUIRE(preset.passes.size() == 1);
    CHECK(preset.passes[0].shader == "x/crt.slang");
    CHECK_FALSE(preset.passes[0].scale.has_value());
}
