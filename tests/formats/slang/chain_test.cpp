#include "formats/slang/slang_folder.h"

#include <fmt/format.h>

namespace {
const std::string owner_text =
    "shaders = 1\nshader0 = a.slang\nalias0 = Owner\ntextures = lut\nlut = base.png\na = 1\nb = "
    "1\n";
}

TEST_CASE("the first reference leads to the passes, which intermediate files cannot change") {
    SlangFolder folder;
    folder.write("deep/base.slangp", owner_text);
    folder.write("middle.slangp",
                 "#reference \"deep/base.slangp\"\nalias0 = Middle\nscale_type0 = viewport\n");
    const auto preset = folder.preset_of(
        "#reference \"middle.slangp\"\nwrap_mode0 = repeat\ntextures = other\nlut_linear = "
        "false\n");
    REQUIRE(preset.has_value());
    REQUIRE(preset->passes.size() == 1);
    CHECK(preset->passes[0].shader == folder / "deep/a.slang");
    CHECK(preset->passes[0].alias == "Owner");
    CHECK(preset->passes[0].wrap == Wrap::border);
    CHECK_FALSE(preset->passes[0].scale.has_value());
    REQUIRE(preset->textures.size() == 1);
    CHECK(preset->textures[0].name == "lut");
    CHECK_FALSE(preset->textures[0].is_linear.has_value());
    CHECK(preset->values.size() == 2);
    CHECK(preset->warnings.empty());
    CHECK(folder.has_seen("middle.slangp"));
    CHECK(folder.has_seen("deep/base.slangp"));
}

TEST_CASE("values and texture paths are applied from the deepest file to the opened one") {
    SlangFolder folder;
    folder.write("deep/base.slangp", owner_text + "c = 1\nd = 1\ne = 1\n");
    folder.write("deep/middle.slangp",
                 "#reference \"base.slangp\"\nb = 2\nc = 2\nd = 2\ne = 2\nlut = middle.png\n");
    folder.write("values/first.params", "c = 3\nd = 3\ne = 3\nlut = first.png\n");
    folder.write("values/second.params", "#reference \"inner.params\"\nd = 4\ne = 4\n");
    folder.write("values/inner.params", "d = 3.5\ninner = 7\n");
    const auto preset = folder.preset_of(
        "#reference \"deep/middle.slangp\"\n#reference \"values/first.params\"\n"
        "#reference \"values/second.params\"\ne = 5\n");
    REQUIRE(preset.has_value());
    for (const auto& value : std::map<std::string, double>{
             {"a", 1}, {"b", 2}, {"c", 3}, {"d", 4}, {"e", 5}, {"inner", 7}})
        CHECK_MESSAGE(preset->values.at(value.first).number == value.second, value.first);
    CHECK(preset->values.at("d").declared == Location{folder / "values/second.params", 2});
    CHECK(preset->textures[0].file == folder / "values/first.png");
    CHECK(preset->textures[0].declared == Location{folder / "values/first.params", 4});
}

TEST_CASE("a preset with only values gives a specific error") {
    SlangFolder folder;
    CHECK(folder.refusal(folder.preset_of("glow = 1\n")) ==
          "a.slangp:1: error: this preset contains values but no passes ('shaders'). Open a preset "
          "that references it.");
    folder.write("values.params", "glow = 1\n");
    CHECK(folder.refusal(folder.preset_of("#reference \"values.params\"\n")) ==
          "values.params:1: error: this preset contains values but no passes ('shaders'), so "
          "'a.slangp' has nothing to draw");
}

TEST_CASE("only the first reference may have passes") {
    SlangFolder folder;
    folder.write("base.slangp", owner_text);
    folder.write("other.slangp", "\nshaders = 1\nshader0 = a.slang\n");
    CHECK(folder.refusal(folder.preset_of("#reference base.slangp\n#reference other.slangp\n")) ==
          "other.slangp:2: error: this file has passes, but only the first #reference of a "
          "preset may lead to passes");
}

TEST_CASE("passes in addition to a reference are ignored with a warning") {
    SlangFolder folder;
    folder.write("base.slangp", owner_text);
    const auto preset = folder.preset_of("#reference base.slangp\nshaders = 2\n");
    REQUIRE(preset.has_value());
    CHECK(preset->passes.size() == 1);
    CHECK(folder.told(preset->warnings) ==
          "a.slangp:2: warning: the passes of this file are ignored; those of its #reference are "
          "used");
}

TEST_CASE("a missing reference is reported at its line, and watched") {
    SlangFolder folder;
    folder.write("deep/base.slangp", "\n#reference \"gone.slangp\"\n");
    CHECK(folder.refusal(folder.preset_of("#reference \"deep/base.slangp\"\n")) ==
          "deep/base.slangp:2: error: can't read 'gone.slangp' (deep/gone.slangp): file not "
          "found");
    CHECK(folder.has_seen("deep/gone.slangp"));
}

TEST_CASE("a missing file of values gives a warning") {
    SlangFolder folder;
    folder.write("base.slangp", owner_text);
    folder.write("a.params", "a = 2\n");
    folder.write("second.params", "#reference \"a.params\"\n#reference \"gone.params\"\n");
    folder.write("first.params", "#reference \"gone.params\"\nb = 3\n");
    const auto preset = folder.preset_of(
        "#reference \"base.slangp\"\n#reference \"second.params\"\n#reference "
        "\"first.params\"\n#reference \"Gone.params\"\n");
    REQUIRE(preset.has_value());
    CHECK(preset->values.at("a").number == 2.0);
    CHECK(preset->values.at("b").number == 3.0);
    CHECK(folder.told(preset->warnings) ==
          "second.params:2: warning: can't read 'gone.params' (gone.params): file not found; "
          "its values are ignored\n"
          "first.params:1: warning: can't read 'gone.params' (gone.params): file not found; "
          "its values are ignored\n"
          "a.slangp:4: warning: can't read 'Gone.params' (Gone.params): file not found; "
          "its values are ignored");
}

TEST_CASE("circular references are an error, also through a link") {
    SlangFolder folder;
    folder.write("b.slangp", "x = 1\n#reference \"a.slangp\"\n");
    CHECK(folder.refusal(folder.preset_of("#reference \"b.slangp\"\n")) ==
          "b.slangp:2: error: circular #reference: a.slangp -> b.slangp -> a.slangp");
    std::filesystem::create_symlink(folder / "a.slangp", folder / "link.slangp");
    folder.write("b.slangp", "#reference \"link.slangp\"\n");
    CHECK(folder.refusal(folder.preset("a.slangp")).find("circular #reference") !=
          std::string::npos);
}

TEST_CASE("references are nested at most 16 files deep") {
    SlangFolder folder;
    // a.slangp is the first file, 14.slangp the 16th.
    for (int i = 0; i < 14; ++i)
        folder.write(fmt::format("{}.slangp", i), fmt::format("#reference {}.slangp\n", i + 1));
    folder.write("14.slangp", owner_text);
    CHECK(folder.preset_of("#reference 0.slangp\n").has_value());
    folder.write("14.slangp", "#reference 15.slangp\n");
    folder.write("15.slangp", owner_text);
    CHECK(folder.refusal(folder.preset("a.slangp")) ==
          "14.slangp:1: error: references are nested deeper than the limit of 16 levels");
}

TEST_CASE("exponentially growing references are limited") {
    SlangFolder folder;
    for (int i = 0; i < 12; ++i)
        folder.write(fmt::format("{}.params", i),
                     fmt::format("#reference {0}.params\n#reference {0}.params\n", i + 1));
    folder.write("12.params", "a = 1\n");
    folder.write("base.slangp", owner_text);
    CHECK(folder.refusal(folder.preset_of("#reference base.slangp\n#reference 0.params\n"))
              .find("the preset has more references than the limit of 256") != std::string::npos);
}

TEST_CASE("wildcards of a reference are replaced if that file exists") {
    SlangFolder folder;
    folder.write("Ref_$PRESET$.slangp", owner_text + "which = 1\n");
    const std::string text = "#reference \"Ref_$PRESET$.slangp\"\n";
    CHECK(folder.preset_of(text)->values.at("which").number == 1.0);
    CHECK(folder.has_seen("Ref_a.slangp"));
    folder.write("Ref_a.slangp", owner_text + "which = 2\n");
    CHECK(folder.preset_of(text)->values.at("which").number == 2.0);
}
