#include "formats/reshade_export/fx_text.h"

#include <doctest/doctest.h>

namespace {
bool has(const FxText& fx, const std::string& part) {
    return fx.text.find(part) != std::string::npos;
}
}  // namespace

TEST_CASE("what an effect declares itself is left out") {
    const FxText fx = fx_text(
        "uniform float gain;\n"
        "Texture2D<float4> scene : register(t0);\n"
        "SamplerState _scene_sampler : register(s0);\n"
        "static float4 color;\n"
        "struct SPIRV_Cross_Output\n{\n    float4 color : SV_Target0;\n};\n"
        "void frag_main()\n{\n    color = gain.xxxx;\n}\n"
        "SPIRV_Cross_Output main()\n{\n    frag_main();\n}\n",
        false);
    CHECK(fx.text == "static float4 color;\nvoid frag_main()\n{\n    color = gain.xxxx;\n}\n");
    CHECK(fx.obstacle.empty());
}

TEST_CASE("methods of textures become functions of samplers") {
    const std::string hlsl =
        "float4 seen(Texture2D<float4> t, SamplerState _t_sampler, float2 p)\n"
        "{\n    return t.Sample(_t_sampler, p + t.Load(int3(0, 1, 2)).xy, int2(1, 0));\n}\n"
        "void frag_main()\n{\n    color = seen(scene, _scene_sampler, p) + "
        "scene.SampleLevel(_scene_sampler, p, 1.0f) + scene.SampleBias(_scene_sampler, p, 0.5f) + "
        "scene.SampleGrad(_scene_sampler, p, a, b);\n}\n";
    const FxText fx = fx_text(hlsl, true);
    CHECK(has(fx, "float4 seen(sampler2D t, float2 p)"));
    CHECK(has(fx, "tex2Doffset(t, p + afterglow_fetch(t, int3(0, 1, 2)).xy, int2(1, 0))"));
    CHECK(has(fx, "seen(scene, p) + tex2Dlod(scene, float4(p, 0.0, 1.0f))"));
    CHECK(has(fx, "afterglow_bias(scene, p, 0.5f) + afterglow_grad(scene, p, a, b)"));

    CHECK(has(fx_text("void f()\n{\n    c = s.Sample(_s_sampler, p);\n}\n", false),
              "tex2Dlod(s, float4(p, 0.0, 0.0))"));
}

TEST_CASE("structures get their values member by member") {
    const FxText fx = fx_text(
        "struct S\n{\n    float x;\n    float2 y[2];\n};\n"
        "static const S _7 = { 1.0f, 2.0f };\n"
        "S made(float v)\n{\n    S _32 = { v, f(v, 2) };\n    s = _7;\n    v = _7.y;\n"
        "    S t = _7;\n    return _32;\n}\n",
        false);
    CHECK(has(fx, "S _32; _32.x = v; _32.y = f(v, 2);"));
    CHECK(has(fx, "s.x = 1.0f; s.y = 2.0f;"));
    CHECK(has(fx, "v = (2.0f);"));
    CHECK(has(fx, "S t; t.x = 1.0f; t.y = 2.0f;"));
    CHECK_FALSE(has(fx, "_7"));
    CHECK(fx.obstacle.empty());
}

TEST_CASE("loops without a counter and long numbers are rewritten") {
    const FxText fx = fx_text(
        "void f()\n{\n    for (;;)\n    {\n        break;\n    }\n    for (; g(i) < 3; )\n    {\n"
        "    }\n    for (int i = 0; i < 3; i++)\n    {\n    }\n    x = 100000002004087734272.0f;\n"
        "    y = 1234567u;\n}\n",
        false);
    CHECK(has(fx, "while (true)"));
    CHECK(has(fx, "while (g(i) < 3)"));
    CHECK(has(fx, "for (int i = 0; i < 3; i++)"));
    CHECK(has(fx, "x = 1.00000002e+20;"));
    CHECK(has(fx, "y = 1234567u;"));
}

TEST_CASE("what ReShade can't read is an obstacle") {
    const auto obstacle = [](const std::string& body) {
        return fx_text("struct S\n{\n    float x;\n};\nvoid f()\n{\n    " + body + "\n}\n", false)
            .obstacle;
    };
    CHECK(obstacle("float2x3 m = n;") == "has matrices that are not square");
    CHECK(obstacle("S s[3];") == "has arrays of structures");
    CHECK(obstacle("float a[2][3];") == "has arrays of arrays");
    CHECK(obstacle("float l = t.CalculateLevelOfDetail(_t_sampler, p);") ==
          "reads a texture by CalculateLevelOfDetail()");
    CHECK(obstacle("float a[2]; return a[i][j];").empty());
}

TEST_CASE("text in quotes has no quotes and line ends of its own") {
    CHECK(fx_string("a \"b\" \\ */\n#c") == "\"a \\\"b\\\" \\\\ */ #c\"");
    CHECK(fx_string("a\\") == "\"a\\\\ \"");
}
