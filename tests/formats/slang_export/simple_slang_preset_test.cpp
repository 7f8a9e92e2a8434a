#include "formats/slang_export/simple_slang_preset.h"

#include "formats/slang/slang_folder.h"

TEST_CASE("a simple preset references the original by a relative path, with sorted short values") {
    CHECK(simple_slang_preset("/shaders/crt/a b.slangp", {{"b", 0.1}, {"a", -2.0}, {"c", 1e-5}},
                              "/shaders/mine/own.slangp") ==
          "#reference \"../crt/a b.slangp\"\n\na = \"-2\"\nb = \"0.1\"\nc = \"1e-05\"\n");
    CHECK(simple_slang_preset("/shaders/crt/../a.slangp", {}, "/shaders/own.slangp") ==
          "#reference \"a.slangp\"\n");
}

TEST_CASE("a value stored as float is written as it was typed") {
    const auto stored = static_cast<double>(0.92f);
    CHECK(simple_slang_preset("/a.slangp", {{"x", stored}}, "/b.slangp") ==
          "#reference \"a.slangp\"\n\nx = \"0.92\"\n");
}

TEST_CASE("a saved simple preset is read back over the preset that it references") {
    SlangFolder folder;
    const auto base =
        folder.write("deep/base.slangp", "shaders = 1\nshader0 = a.slang\nglow = 1\nbend = 1\n");
    const auto own = folder / "own/mine.slangp";
    const std::map<std::string, double> values{{"glow", 0.123456789}, {"odd-name", 3e20}};
    folder.write("own/mine.slangp", simple_slang_preset(base, values, own));
    const auto preset = folder.preset("own/mine.slangp");
    REQUIRE(preset.has_value());
    CHECK(preset->passes[0].shader == folder / "deep/a.slang");
    CHECK(static_cast<float>(preset->values.at("glow").number) == 0.123456789f);
    CHECK(static_cast<float>(preset->values.at("odd-name").number) == 3e20f);
    CHECK(preset->values.at("bend").number == 1.0);
    CHECK(preset->warnings.empty());
}

TEST_CASE("a simple preset of a single shader has one pass") {
    SlangFolder folder;
    const auto shader = folder.write("deep/a.slang", "");
    folder.write("own/mine.slangp",
                 simple_slang_preset(shader, {{"glow", 0.5}}, folder / "own/mine.slangp"));
    const auto preset = folder.preset("own/mine.slangp");
    REQUIRE(preset.has_value());
    REQUIRE(preset->passes.size() == 1);
    CHECK(preset->passes[0].shader == folder / "deep/a.slang");
    CHECK(!preset->passes[0].scale);
    CHECK(preset->values.at("glow").number == 0.5);
    CHECK(preset->warnings.empty());
}
