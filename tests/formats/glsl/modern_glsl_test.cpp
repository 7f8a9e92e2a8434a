#include "formats/glsl/modern_glsl.h"

#include <doctest/doctest.h>

TEST_CASE("identifiers reserved in GLSL 4.10 are renamed, except in comments") {
    CHECK(modern_glsl("float sample = 1.0; // a sample\nfloat b = sample;") ==
          "float sample_ = 1.0; // a sample\nfloat b = sample_;");
    CHECK(modern_glsl("float sample, sample_;") == "float sample_x, sample_;");
    CHECK(modern_glsl("#define buffer 3\nint a = buffer;") ==
          "#define buffer_ 3\nint a = buffer_;");
    CHECK(modern_glsl("float resampled;") == "float resampled;");
}

TEST_CASE("a word stays if it is a keyword in the version of the text") {
    constexpr GlslVersion newest{450, false};
    CHECK(modern_glsl("double sample; sample in vec2 a;", {}, newest) ==
          "double sample; sample in vec2 a;");
    CHECK(modern_glsl("uint a = uint(1);", {}, {100, true}) == "uint a = uint(1);");
    CHECK(modern_glsl("float smooth = 1.0; a = smooth;", {}, {100, true}) ==
          "float smooth_ = 1.0; a = smooth_;");
    CHECK(modern_glsl("smooth in vec2 a; float filter;", {}, {330, false}) ==
          "smooth in vec2 a; float filter_;");
}

TEST_CASE("the version is that of #version, else GLSL ES 1.00") {
    const auto version_in = [](std::string_view text) {
        const GlslVersion version = glsl_version_of(text);
        return std::pair(version.words, version.is_es);
    };
    CHECK(version_in("float a;") == std::pair(100, true));
    CHECK(version_in("#version 100\n") == std::pair(100, true));
    CHECK(version_in("// why\n#version 300 es\n") == std::pair(330, true));
    CHECK(version_in("#version 120\n") == std::pair(120, false));
    CHECK(version_in("#version 450 core\n") == std::pair(450, false));
}

TEST_CASE("GL_ES is defined only for ES, under a valid name") {
    CHECK(modern_glsl("#ifdef GL_ES\n") == "#ifdef afterglow_es\n");
    CHECK(modern_glsl("#ifdef GL_ES\n", {}, {330, false}) == "#ifdef GL_ES\n");
    CHECK(modern_glsl_start({"GL_ES"}) == "#version 410 core\n#define afterglow_es 1\n");
}

TEST_CASE("old texture functions get their modern names") {
    CHECK(modern_glsl("texture2D(a, b) + textureCubeLodEXT(c, d, 1.0)") ==
          "texture(a, b) + textureLod(c, d, 1.0)");
    CHECK(modern_glsl("uniform sampler2D texture; x = texture2D(texture, uv);") ==
          "uniform sampler2D texture_; x = texture(texture_, uv);");
    CHECK(modern_glsl("#define T texture\nT(a, b)") == "#define T texture\nT(a, b)");
}

TEST_CASE("continued lines are joined, and later lines keep their numbers") {
    CHECK(modern_glsl("#define A(x) \\\n  (x + \\\n  1.0)\nfloat b;") ==
          "#define A(x)   (x +   1.0)\n\n\nfloat b;");
}

TEST_CASE("a minus sign in a macro is separated from the sign of its argument") {
    CHECK(modern_glsl("#define D(a, b) (a-b)\nx-y") == "#define D(a, b) (a- b)\nx-y");
}

TEST_CASE("#version, #extension and #line are blanked out") {
    CHECK(modern_glsl("#version 300 es\nfloat a;") == "  \nfloat a;");
    CHECK(modern_glsl("# extension GL_X : enable // why\nfloat a;").find("GL_X") ==
          std::string::npos);
    CHECK(modern_glsl("#define version 3\n#line 7\n") == "#define version 3\n \n");
}

TEST_CASE("additional replacements apply to whole words of code") {
    CHECK(modern_glsl("varying vec2 varyings; // varying", {{"varying", "in"}}) ==
          "in vec2 varyings; // varying");
}

TEST_CASE("an extension is enabled if its functions are used") {
    const auto start_of = [](std::string_view text) {
        GlslWords words;
        add_words(text, words);
        return modern_glsl_start(words);
    };
    CHECK(start_of("float a; // packHalf2x16") == "#version 410 core\n");
    CHECK(start_of("uint a = packHalf2x16(b);") ==
          "#version 410 core\n#extension GL_ARB_shading_language_packing : enable\n");
}
