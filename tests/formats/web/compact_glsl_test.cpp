#include "formats/web/compact_glsl.h"

#include <doctest/doctest.h>

TEST_CASE("blanks and line ends go, directives keep their lines") {
    CHECK(compact_glsl("#version 300 es\nprecision highp float;\n\n"
                       "void main()\n{\n    int a = 1;\n    if (a == 1)\n        return;\n}\n") ==
          "#version 300 es\nprecision highp float;void main(){int a=1;if(a==1)return;}\n\n");
    CHECK(compact_glsl("#define N 3\n#ifdef N\nfloat a;\n#endif\nfloat b;\n") ==
          "#define N 3\n#ifdef N\nfloat a;\n#endif\nfloat b;\n");
}

TEST_CASE("operators stay apart where they would become another") {
    CHECK(compact_glsl("int a = b - -c + +d--;") == "int a=b- -c+ +d--;\n");
}

TEST_CASE("numbers are as short as the same float allows") {
    CHECK(compact_glsl("x = 0.100000001490116119384765625 + 1.0 * 2.5000000;") ==
          "x=0.1+1.0*2.5;\n");
    CHECK(compact_glsl("y = 0.0000000000000000000099999996826552253889678874634872;") ==
          "y=1e-20;\n");
    CHECK(compact_glsl("z = 7u + 0x10u + 3;") == "z=7u+0x10u+3;\n");
}
