#include "glsl/es/es_program.h"
#include <doctest/doctest.h>
#include <cstdio>
TEST_CASE("zzfuzz") {
    Stage v; v.file="a"; v.text="#version 410 core\nvoid main() { gl_Position = vec4(0); }\n";
    for (const char* body : {
        "float a[N] = float[N](1.,2.); void main(){ color = vec4(a[0]); }",
        "void main(){ float a[N] = float[](1.,2.); color = vec4(a[0]); }",
        "const float a[N] = float[](1.,2.); void main(){ color = vec4(a[1]); }",
        "void main(){ vec4 v = vec4(1); color = vec4(v[N]); }",
        "const int M = N * 2; void main(){ float a[M]; a[0] = 1.0; color = vec4(a[0]); }",
        "const float F = float(N) * 2.0; void main(){ color = vec4(F); }",
        "const vec2 F = vec2(N, 1); void main(){ color = F.xyxy; }",
        "uniform sampler2D s; void main(){ color = textureOffset(s, vec2(0), ivec2(N, 0)); }",
        "float f(float a[N]) { return a[0]; } void main(){ float b[N]; b[0]=1.; color = vec4(f(b)); }",
        "float f(float a[N]) { return a[0]; } void main(){ float b[2]; b[0]=1.; color = vec4(f(b)); }",
        "struct S { float a[N]; }; void main(){ S s; s.a[0]=1.; color = vec4(s.a[0] + float(s.a.length())); }",
        "const bool B = N > 1; void main(){ if (B) color = vec4(1); else color = vec4(N == 2 ? 1 : 0); }",
        "void main(){ color = vec4(0); for (int i = 0; i < N; ++i) for (int j = N; j > 0; --j) color += vec4(j); }",
        "void main(){ float a[3]; a[N] = 1.0; color = vec4(a[N - 1]); }",
        "const int A[2] = int[](N, 3); void main(){ color = vec4(A[1]); }",
        "const mat2 A = mat2(N, 3, 1, 2); void main(){ color = vec4(A[1], 0, 0); }",
        "uniform float u[N]; void main(){ color = vec4(u[0]); }",
        "float g = float(N); void main(){ color = vec4(g); }",
        "void main(){ const float x = sin(float(N)); color = vec4(x); }",
        "void main(){ color = vec4(1 / (N - 2)); }",
        "void main(){ float a[N][2]; a[0][1] = 1.0; color = vec4(a[0][1]); }",
    }) {
        Stage f; f.file="b"; f.text=std::string("#version 430 core\n#define N 2  // @range 1 9\nout vec4 color;\n")+body+"\n";
        std::printf("%s\n", body); std::fflush(stdout);
        const auto p = translate_to_es(v, f, {}, {{"N", 0}});
        std::printf("  -> %s\n", p ? "ok" : p.error().front().message.c_str()); std::fflush(stdout);
    }
}
