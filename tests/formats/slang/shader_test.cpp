#include "formats/slang/slang_folder.h"

namespace {
// The definitions after #version in every stage.
const std::string host =
    "#define _HAS_ORIGINALASPECT_UNIFORMS\n"
    "#define _HAS_FRAMETIME_UNIFORMS\n"
    "#define _HAS_ROTATION_UNIFORM\n"
    "#define _HAS_SENSOR_UNIFORMS\n";
}  // namespace

TEST_CASE("text before the first stage belongs to both stages") {
    SlangFolder folder;
    const auto shader = folder.shader_of(
        "#version 450\nint both;\n#pragma stage vertex\nint v;\n#pragma stage fragment\nint f;\n");
    REQUIRE(shader.has_value());
    CHECK(shader->vertex.text == "#version 450\n" + host + "int both;\n\nint v;\n");
    CHECK(shader->fragment.text == "#version 450\n" + host + "int both;\n\nint f;\n");
    CHECK(shader->vertex.file == folder / "a.slang");
    CHECK(shader->fragment.file == folder / "a.slang");
}

TEST_CASE("a stage may be reopened, and a comment may follow its name") {
    SlangFolder folder;
    const auto shader = folder.shader_of(
        "#version 450\n#pragma stage fragment // here\nint a;\n#pragma stage vertex\nint b;\n"
        "#pragma stage fragment\nint c;\n");
    REQUIRE(shader.has_value());
    CHECK(shader->fragment.text == "#version 450\n" + host + "\nint a;\n\nint c;\n");
    CHECK(shader->vertex.text == "#version 450\n" + host + "\nint b;\n");
}

TEST_CASE("every line of a stage maps to its original line, also after removed lines") {
    SlangFolder folder;
    const auto inc = folder.write("sub/x.inc", "float x;\n#pragma name X\nfloat y;");
    const auto shader = folder.shader_of(
        "#version 450\r\n#include \"sub/x.inc\"\r\n#pragma stage vertex\r\nint v;\r\n"
        "#pragma stage fragment\r\nint f;\r\n");
    const auto top = folder / "a.slang";
    REQUIRE(shader.has_value());
    CHECK(shader->fragment.text == "#version 450\n" + host + "float x;\n\nfloat y;\n\nint f;\n");
    CHECK(shader->fragment.lines == LineMap{{top, 1},
                                            {top, 1},
                                            {top, 1},
                                            {top, 1},
                                            {top, 1},
                                            {inc, 1},
                                            {inc, 2},
                                            {inc, 3},
                                            {top, 5},
                                            {top, 6}});
    CHECK(split_lines(shader->fragment.text).size() == shader->fragment.lines.size());
    CHECK(split_lines(shader->vertex.text).size() == shader->vertex.lines.size());
}

TEST_CASE("the first line of a shader must be #version") {
    SlangFolder folder;
    const std::string expected = "a.slang:1: error: the shader's first line must be #version";
    CHECK(folder.refusal(folder.shader_of("\n#version 450\n")) == expected);
    CHECK(folder.refusal(folder.shader_of("// hello\n#version 450\n")) == expected);
    CHECK(folder.refusal(folder.shader_of("")) == expected);
    CHECK(folder.refusal(folder.shader_of("#include \"v.inc\"\n#pragma stage vertex\n"))
              .starts_with("a.slang:1: error: can't include 'v.inc'"));
    CHECK(folder.shader_of("\xef\xbb\xbf#version 450\n").has_value());
    CHECK(folder.shader_of("#version 310 es").has_value());
}

TEST_CASE("only vertex and fragment are valid stages") {
    SlangFolder folder;
    CHECK(folder.refusal(folder.shader_of("#version 450\n#pragma stage pixel\n")) ==
          "a.slang:2: error: unknown stage 'pixel'; use #pragma stage vertex or #pragma stage "
          "fragment");
}

TEST_CASE("the first #pragma name and format of a shader count") {
    SlangFolder folder;
    const auto shader = folder.shader_of(
        "#version 450\n#pragma name Blurred // ours\n  #  pragma format R16G16B16A16_SFLOAT\n"
        "#pragma format R8_UNORM\n#pragma name Blurred\n#pragma optimize(on)\n");
    REQUIRE(shader.has_value());
    CHECK(shader->alias == "Blurred");
    CHECK(shader->alias_declared == Location{folder / "a.slang", 2});
    CHECK(shader->format == "R16G16B16A16_SFLOAT");
    CHECK(shader->format_declared == Location{folder / "a.slang", 3});
    CHECK(folder.told(shader->warnings) ==
          "a.slang:4: warning: #pragma format 'R8_UNORM' is ignored because line 3 has #pragma "
          "format 'R16G16B16A16_SFLOAT'");
    CHECK(shader->vertex.text == "#version 450\n" + host + "\n\n\n\n#pragma optimize(on)\n");
}

TEST_CASE("a #line directive is removed") {
    SlangFolder folder;
    const auto shader = folder.shader_of("#version 450\n#line 77 \"other.c\"\nint a;\n");
    REQUIRE(shader.has_value());
    CHECK(shader->vertex.text == "#version 450\n" + host + "\nint a;\n");
}

TEST_CASE("parameters of a shader are read in order with their locations") {
    SlangFolder folder;
    const auto inc = folder.write("p.inc", "#pragma parameter glow \"Glow\" .5 0 1 0.25\n");
    const auto shader = folder.shader_of(
        "#version 450\n#include \"p.inc\"\n#pragma parameter bend \"Bend: \\ * !\" 1e-1 -1.0 1\n"
        "#pragma parameter glow \"Glow\" 0.50 0.0 1.00 0.25\n#include \"p.inc\"\n");
    REQUIRE(shader.has_value());
    REQUIRE(shader->parameters.size() == 2);
    CHECK(*shader->parameters[0] == SlangParameter{"glow", "Glow", 0.5, 0.0, 1.0, 0.25, {inc, 1}});
    CHECK(*shader->parameters[1] ==
          SlangParameter{"bend", "Bend: \\ * !", 0.1, -1.0, 1.0, 0.2, {folder / "a.slang", 3}});
    CHECK(shader->warnings.empty());
}

TEST_CASE("a parameter redeclared with other numbers keeps the first ones, with a warning") {
    SlangFolder folder;
    const auto shader = folder.shader_of(
        "#version 450\n#pragma parameter a \"A\" 1 0 2 1\n#pragma parameter a \"A\" 1 0 3 1\n");
    REQUIRE(shader.has_value());
    REQUIRE(shader->parameters.size() == 1);
    CHECK(shader->parameters[0]->maximum == 2.0);
    CHECK(folder.told(shader->warnings) ==
          "a.slang:3: warning: parameter 'a' has the numbers 1 0 3 1 here but 1 0 2 1 at "
          "a.slang:2; the first declaration is used");
}

TEST_CASE("an invalid parameter is an error at its line") {
    SlangFolder folder;
    CHECK(folder.refusal(folder.shader_of("#version 450\n#pragma parameter a \"A\" 1 0\n"
                                          "#pragma parameter b 1 0 1\n"
                                          "#pragma parameter c \"C\" 1 0 x\n"
                                          "#pragma parameter d e \"D\" 1 0 1\n")) ==
          "a.slang:2: error: parameter 'a' needs three numbers after its label: initial, minimum "
          "and maximum\n"
          "a.slang:3: error: expected #pragma parameter NAME \"Label\" initial "
          "minimum maximum step\n"
          "a.slang:4: error: parameter 'c' needs three numbers after its label: initial, minimum "
          "and maximum\n"
          "a.slang:5: error: expected #pragma parameter NAME \"Label\" initial "
          "minimum maximum step");
}
