#include "formats/slang/controls.h"
#include "in_a_moment.h"
#include "slang_folder.h"

#include <fmt/format.h>

TEST_CASE("a preset with everything it references is limited to 8 MiB, counted each time") {
    SlangFolder folder;
    folder.write("owner.slangp", "shaders = 1\nshader0 = a.slang\n");
    folder.write("big.params", "// " + std::string((1 << 20) - 4, 'x') + "\n");
    const std::string text = "#reference owner.slangp\n" + times(7, "#reference big.params\n");
    CHECK(folder.preset_of(text).has_value());
    CHECK(folder.refusal(folder.preset_of(text + "#reference big.params\n")) ==
          "a.slangp:9: error: the preset with its references and includes is larger than the limit "
          "of 8 MiB");
    folder.write("more.params", times(9, "#include \"big.params\"\n"));
    CHECK(folder.refusal(folder.preset_of("#reference owner.slangp\n#reference more.params\n"))
              .find("more.params:8: error: the preset with its references and includes is larger "
                    "than the limit of 8 MiB") != std::string::npos);
}

TEST_CASE("a preset has at most 256 references, and the next one is an error at its line") {
    SlangFolder folder;
    CHECK(folder.refusal(folder.preset_of(times(300, "#reference owner.slangp\n"))) ==
          "a.slangp:257: error: the preset has more references than the limit of 256");
}

TEST_CASE("only the first 256 lines that a preset ignores are reported") {
    SlangFolder folder;
    const auto preset =
        folder.preset_of("shaders = 1\nshader0 = a.slang\n" + times(100'000, "nonsense\n"));
    REQUIRE(preset.has_value());
    CHECK(preset->warnings.size() == 257);
}

TEST_CASE("very many textures are rejected fast") {
    SlangFolder folder;
    std::string list;
    for (int i = 0; i < 100'000; ++i)
        list += fmt::format("t{};", i);
    CHECK(folder.refusal(
              folder.preset_of("shaders = 1\nshader0 = a.slang\ntextures = \"" + list + "\"\n")) ==
          "a.slangp:3: error: the preset has 100000 textures; the limit is 64");
}

TEST_CASE("a path longer than 4096 bytes is an error at its line") {
    SlangFolder folder;
    const std::string path = times(2000, "../") + "x";
    const std::string message = "error: the path is longer than the limit of 4096 bytes";
    CHECK(folder.refusal(folder.preset_of("shaders = 1\nshader0 = " + path + "\n")) ==
          "a.slangp:2: " + message);
    CHECK(folder.refusal(folder.preset_of("#reference " + path + "\n")) ==
          "a.slangp:1: " + message);
    CHECK(folder.refusal(folder.preset_of("#include " + path + "\n")) == "a.slangp:1: " + message);
    CHECK(folder.refusal(folder.shader_of("#version 450\n#include \"" + path + "\"\n")) ==
          "a.slang:2: " + message);
}

TEST_CASE("a shader has at most 16384 parameters, and only its first errors are listed") {
    SlangFolder folder;
    std::string many = "#version 450\n";
    for (int i = 0; i < 16'384; ++i)
        many += fmt::format("#pragma parameter p{} \"\" 0 0 1\n", i);
    CHECK(folder.shader_of(many).has_value());
    CHECK(folder.refusal(folder.shader_of(many + "#pragma parameter q \"\" 0 0 1\n")) ==
          "a.slang:16386: error: the shader has 16385 parameters; the limit is 16384");
    const auto wrong = folder.shader_of("#version 450\n" + times(10'000, "#pragma parameter\n"));
    REQUIRE_FALSE(wrong.has_value());
    CHECK(wrong.error().size() == 257);
}

TEST_CASE("directives count towards the size limit of a shader") {
    SlangFolder folder;
    folder.write("pragmas.inc", times(40'000, "#pragma name the_name_of_a_pass\n"));
    const auto shader =
        folder.shader_of("#version 450\n" + times(100, "#include \"pragmas.inc\"\n"));
    CHECK(folder.refusal(shader).find("larger than the limit of 8 MiB") != std::string::npos);
}

TEST_CASE("numbers outside the 32-bit float range are reported, in presets and parameters") {
    SlangFolder folder;
    for (const char* number : {"1e999", "1e39", "-1e39", "nan", "inf"}) {
        const auto preset = folder.preset_of(fmt::format(
            "shaders = 1\nshader0 = a.slang\nscale_type0 = source\nscale0 = {0}\nx = {0}\n",
            number));
        REQUIRE(preset.has_value());
        CHECK(folder.told(preset->warnings) ==
              fmt::format("a.slangp:4: warning: 'scale0' must be a number, got '{0}'; 0 is used\n"
                          "a.slangp:5: warning: 'x' must be a number, got '{0}'; it is ignored",
                          number));
        CHECK(folder.refusal(folder.shader_of(
                  fmt::format("#version 450\n#pragma parameter a \"A\" 0 0 {}\n", number))) ==
              "a.slang:2: error: parameter 'a' needs three numbers after its label: initial, "
              "minimum and maximum");
    }
}

TEST_CASE("invalid counts are rejected or clamped") {
    SlangFolder folder;
    for (const char* count : {"0", "-1", "65", "1e30", "nan", "x"})
        CHECK(folder.refusal(folder.preset_of(fmt::format("shaders = {}\n", count))) ==
              fmt::format("a.slangp:1: error: 'shaders' must be a number of passes from 1 to 64, "
                          "got '{}'",
                          count));
    const auto preset = folder.preset_of(
        "shaders = 1\nshader0 = a.slang\nframe_count_mod0 = 1e30\nscale_type0 = absolute\n"
        "scale0 = -1e30\n");
    REQUIRE(preset.has_value());
    CHECK(preset->passes[0].frame_count_mod == 1 << 24);
}
