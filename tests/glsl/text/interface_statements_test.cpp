#include "glsl/text/interface_statements.h"

#include <doctest/doctest.h>

namespace {
using Kind = InterfaceStatement::Kind;

std::string text_of(std::string_view text, const InterfaceStatement& statement) {
    return std::string(text.substr(statement.begin, statement.end - statement.begin));
}
}  // namespace

TEST_CASE("uniforms, inputs and outputs are found with their types, names and values") {
    const std::string text =
        "#version 410 core\n"
        "uniform vec3 tint = vec3(1.0, 0.5, 0.0), shade;  // both\n"
        "layout(location = 2) flat in ivec2 at[3];\n"
        "out vec4 color;\n"
        "const float half = 0.5;\n"
        "vec4 mixed(in vec4 a, out float b) { uniform_like(a); return a; }\n"
        "uniform highp sampler2D image;\n";
    const auto found = find_interface_statements(text);
    REQUIRE(found.size() == 4);
    CHECK(text_of(text, found[0]) == "uniform vec3 tint = vec3(1.0, 0.5, 0.0), shade;");
    REQUIRE(found[0].declarators.size() == 2);
    CHECK(found[0].declarators[0].name == "tint");
    CHECK(found[0].declarators[0].initialiser == "vec3(1.0, 0.5, 0.0)");
    CHECK(found[0].declarators[1].name == "shade");
    CHECK(found[1].kind == Kind::input);
    CHECK(found[1].is_flat);
    CHECK(found[1].location == 2);
    CHECK(found[1].declarators[0].size == "[3]");
    CHECK(found[2].kind == Kind::output);
    CHECK(found[3].type == "sampler2D");
}

TEST_CASE("statements are found in every branch of the preprocessor, and after functions") {
    const std::string text =
        "#if A\nuniform int a;\n#else\nuniform float a;\n#endif\n"
        "struct S { float x; };\nvoid f() { if (true) { } }\nuniform S s;\n";
    const auto found = find_interface_statements(text);
    REQUIRE(found.size() == 3);
    CHECK(found[1].type == "float");
    CHECK(found[2].type == "S");
    CHECK(found[2].declarators[0].name == "s");
}

TEST_CASE("a block has no declarators") {
    const auto found = find_interface_statements("in Block { vec2 a; } block;\nin vec2 b;\n");
    REQUIRE(found.size() == 2);
    CHECK(found[0].is_block);
    CHECK(found[0].declarators.empty());
    CHECK(found[1].declarators[0].name == "b");
}

TEST_CASE("text that ends early gives what is complete") {
    CHECK(find_interface_statements("uniform").empty());
    CHECK(find_interface_statements("uniform vec2 a = vec2(").size() <= 1);
    CHECK(find_interface_statements("}{)(;;uniform float a;").size() <= 1);
}

TEST_CASE("global names are functions, variables, structs and macros, not locals") {
    const std::string text =
        "#define SIZE 3\nstruct S { float field; };\nconst float a = 1.0, b = 2.0;\n"
        "float[2] c;\nvec2 f(float argument) { float local = argument; return vec2(local); }\n"
        "uniform vec2 u;\n";
    CHECK(global_names(text) == std::vector<std::string>{"S", "SIZE", "a", "b", "c", "f", "u"});
}
