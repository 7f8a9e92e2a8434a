#include "glsl/es/es_constants.h"

#include <doctest/doctest.h>

TEST_CASE("a constant that #if or a case evaluates can't be specialised") {
    const std::string plain = "#version 410 core\n#define N 4  // @range 1 9\nint n = N;\n";
    CHECK(can_be_specialized(plain, "N"));
    CHECK_FALSE(can_be_specialized(plain, "M"));
    CHECK_FALSE(can_be_specialized(plain + "#if N > 2\n#endif\n", "N"));
    CHECK_FALSE(can_be_specialized(plain + "#define M (N + 1)\n#if 0\n#elif M\n#endif\n", "N"));
    CHECK_FALSE(can_be_specialized(
        plain + "void f() { const int m = N + 1; switch (1) { case m: break; } }\n", "N"));
    CHECK(can_be_specialized(plain + "void f() { switch (N) { case 1: break; } }\n", "N"));
    CHECK(can_be_specialized(plain + "#ifdef N\n#endif\n", "N"));
}

TEST_CASE("a constant is declared after the directives that must come first") {
    const std::string text = with_es_constants(
        "#version 410 core\n#extension GL_ARB_x : enable\n#define N 4u  // @range 1 9\n",
        {{"N", 3}});
    CHECK(text ==
          "#version 410 core\n#extension GL_ARB_x : enable\n"
          "layout(constant_id = 3) const uint es_constant_3 = 4u; \n"
          "#define N es_constant_3  // @range 1 9\n");
}
