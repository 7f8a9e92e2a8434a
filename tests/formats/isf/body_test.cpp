#include "formats/isf/body.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
std::string fragment_body(const std::string& code) {
    return isf_body(code, IsfStage::fragment, {"TIME", "speed", "texture", "smooth"});
}
}  // namespace

TEST_CASE("deprecated names are replaced by those of GLSL 4.10") {
    CHECK(fragment_body("gl_FragColor = texture2D(a, vv_FragNormCoord);") ==
          "isf_FragColor = texture(a, isf_FragNormCoord);");
    CHECK(fragment_body("texture2DRect(a, p) + textureCube(b, q);") ==
          "texture(a, p) + texture(b, q);");
    CHECK(fragment_body("varying vec2 at;") == "in vec2 at;");
    CHECK(isf_body("varying vec2 at;", IsfStage::vertex, {}) == "out vec2 at;");
    CHECK(isf_body("vv_vertShaderInit();", IsfStage::vertex, {}) == "isf_vertShaderInit();");
}

TEST_CASE(
    "identifiers that became reserved are renamed, also in macros, but not as parts of words") {
    CHECK(fragment_body("float sample = buffer;") == "float isf_own_sample = isf_own_buffer;");
    CHECK(fragment_body("#define sample 1\nint i = sample;") ==
          "#define isf_own_sample 1\nint i = isf_own_sample;");
    CHECK(fragment_body("float samples; // sample") == "float samples; // sample");
}

TEST_CASE("a user function named like a new built-in is renamed, and other built-ins stay") {
    CHECK(fragment_body("float noise1(float x) { return x; } float y = noise1(2.0);") ==
          "float isf_own_noise1(float x) { return x; } float y = isf_own_noise1(2.0);");
    CHECK(fragment_body("float y = ldexp(x, 2);") == "float y = ldexp(x, 2);");
    CHECK(fragment_body("return fma(a, b, c);") == "return fma(a, b, c);");
}

TEST_CASE("redeclared built-in uniforms and inputs are blanked out") {
    CHECK(fragment_body("uniform float TIME;\nuniform highp float speed;\nuniform float own;") ==
          "                   \n                          \nuniform float own;");
}

TEST_CASE("#version and #extension are blanked out, and line numbers stay") {
    const std::string body =
        fragment_body("#version 120\n#extension GL_EXT_x : enable\n#define A \\\n  2\nfloat x;\n");
    CHECK(std::count(body.begin(), body.end(), '\n') == 5);
    CHECK(body.find("version") == std::string::npos);
    CHECK(body.find("extension") == std::string::npos);
    CHECK(body.find("#define A \\\n  2\nfloat x;\n") != std::string::npos);
}

TEST_CASE("an input named like a GLSL function or keyword is renamed, but calls are not") {
    CHECK(fragment_body("texture2D(texture, p) * smooth;") ==
          "texture(isf_own_texture, p) * isf_own_smooth;");
    CHECK(fragment_body("switch (x) { default: a.texture; }") ==
          "switch (x) { default: a.texture; }");
    CHECK(isf_declared_name("texture") == "isf_own_texture");
    CHECK(isf_declared_name("sample") == "isf_own_sample");
    CHECK(isf_declared_name("textures") == "textures");
}
