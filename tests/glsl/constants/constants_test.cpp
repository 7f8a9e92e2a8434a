#include "glsl/constants/constants.h"

#include <doctest/doctest.h>

namespace {
// Name, type, number times 100 and the written text of each constant.
std::string found_in(const std::string& text) {
    std::string all;
    for (const WrittenConstant& found : find_constants(text)) {
        const std::string written = text.substr(found.begin, found.end - found.begin);
        all += found.name + ' ' + glsl_name(found.type) + ' ' +
               (found.number ? std::to_string(static_cast<int>(*found.number * 100.0)) : "none") +
               " [" + written + "]\n";
    }
    return all;
}
}  // namespace

TEST_CASE("a #define with a range is a constant with the type of its number") {
    CHECK(found_in("#define STEPS 64  // @range 8 256 1\n") == "STEPS int 6400 [64]\n");
    CHECK(found_in("#define GLOW .35 // soft  @range 0 1\n") == "GLOW float 35 [.35]\n");
    CHECK(found_in("#define N 3u // @range 0 9\n") == "N uint 300 [3u]\n");
    CHECK(found_in("#define N 0x10 // @range 0 90\n") == "N int 1600 [0x10]\n");
    CHECK(found_in("#define N 010 // @range 0 90\n") == "N int 800 [010]\n");
    CHECK(found_in("  #  define E 1e1f /* @range 0 90 */\n") == "E float 1000 [1e1f]\n");
    CHECK(found_in("#define LOW (-2.5) // @range -9 9\n") == "LOW float -250 [-2.5]\n");
    CHECK(found_in("#define SOFT true // @label \"Soft\"\n") == "SOFT bool 100 [true]\n");
    CHECK(found_in("#define MODE 1 // @items \"A\" \"B\"\n") == "MODE int 100 [1]\n");
}

TEST_CASE("a const has its declared type in every scope") {
    CHECK(found_in("const float GLOW = 1;  // @range 0 2") == "GLOW float 100 [1]\n");
    CHECK(found_in("const highp float G = -1.5;  // @range -2 2") == "G float -150 [-1.5]\n");
    CHECK(found_in("const float A = 0.5, B = .25; // @range 0 1\n") ==
          "A float 50 [0.5]\nB float 25 [.25]\n");
    CHECK(found_in("void f() {\n    const int N = 4;  // @range 1 9\n}\n") == "N int 400 [4]\n");
    CHECK(found_in("const bool ON = false; // @label \"On\"\n") == "ON bool 0 [false]\n");
    CHECK(found_in("const uint N = 4u; // @range 1 9") == "N uint 400 [4u]\n");
}

TEST_CASE("definitions without annotation and non-constants are ignored") {
    CHECK(found_in("#define STEPS 64\n#define A 1 // by somebody@home\n").empty());
    CHECK(found_in("const float A = 1.0;\nuniform float b = 0.5;  // @range 0 1\n").empty());
    CHECK(found_in("#define F(x) 3 // @range 0 1\n#define EMPTY // @range 0 1\n").empty());
    CHECK(
        found_in("float f(const in vec3 p, const float q) { return q; } // @range 0 1\n").empty());
    CHECK(found_in("// #define A 1 @range 0 1\n#if A > 1 // @range 0 1\n#endif\n").empty());
    CHECK(found_in("#undef A // @range 0 1\n").empty());
}

TEST_CASE("a constant that is not one plain number is found without a value") {
    CHECK(found_in("#define A B // @range 0 1\n") == "A float none []\n");
    CHECK(found_in("#define A 1 + 2 // @range 0 1\n") == "A float none []\n");
    CHECK(found_in("const vec3 C = vec3(1.0, 2.0, 3.0);  // @range 0 1\n") == "C float none []\n");
    CHECK(found_in("const float A[2] = float[2](1.0, 2.0);  // @range 0 1\n") ==
          "A float none []\n");
    CHECK(found_in("#define A 4294967295 // @range 0 1\n") == "A float none []\n");
}

TEST_CASE("each definition is found on its line, with only its own comment") {
    const auto found = find_constants(
        "#ifndef N\n"
        "#define N 3  // @range 1 9\n"
        "             // @label \"Number\"\n"
        "#endif\n"
        "#define M 4\n"
        "const float K = 0.5;  // @range 0 1\n");
    REQUIRE(found.size() == 2);
    CHECK(found[0].name == "N");
    CHECK(found[0].line == 2);
    CHECK(found[0].comments.size() == 2);
    CHECK(found[1].name == "K");
    CHECK(found[1].line == 6);
    CHECK(found[1].comments.size() == 1);
}

TEST_CASE("numbers are written so that GLSL parses the same value and type") {
    const NumberType real{Scalar::floating, 1, 1};
    const NumberType whole{Scalar::integer, 1, 1};
    CHECK(glsl_number(real, 2.0) == "2.0");
    CHECK(glsl_number(real, 0.35) == "0.35");
    CHECK(glsl_number(real, 1e-7) == "1e-07");
    CHECK(glsl_number(real, -0.5) == "(-0.5)");
    CHECK(glsl_number(whole, 7.0) == "7");
    CHECK(glsl_number(whole, -7.0) == "(-7)");
    CHECK(glsl_number({Scalar::unsigned_integer, 1, 1}, 7.0) == "7u");
    CHECK(glsl_number({Scalar::boolean, 1, 1}, 1.0) == "true");
}
