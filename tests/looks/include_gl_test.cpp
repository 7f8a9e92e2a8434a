// The shared GLSL compared with closed forms and published tables, run on software GL.
#include "about.h"
#include "looks/glsl_function.h"
#include "model/look/color.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace {
/// x: a grey; w: the index of the tone map.
constexpr const char* tone_maps =
    "#include \"tonemap.glsl\"\n"
    "vec4 f(vec4 x) { return vec4(tone_mapped(x.rgb, int(x.w), 4.0), 1.0); }\n";

Vec4 grey(double level, int curve) {
    return {level, level, level, static_cast<double>(curve)};
}

/// B. Wrensch's polynomial for AgX's curve; its published mean squared error is 3.7e-6.
double agx_polynomial(double x) {
    const double x2 = x * x;
    const double x4 = x2 * x2;
    return 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 +
           0.1191 * x - 0.00232;
}

/// PCG3D in C++, as in the paper.
std::array<std::uint32_t, 3> pcg3d(std::array<std::uint32_t, 3> v) {
    const auto mix = [&v] {
        v[0] += v[1] * v[2];
        v[1] += v[2] * v[0];
        v[2] += v[0] * v[1];
    };
    for (std::uint32_t& part : v)
        part = part * 1664525u + 1013904223u;
    mix();
    for (std::uint32_t& part : v)
        part ^= part >> 16u;
    mix();
    return v;
}
}  // namespace

TEST_CASE("the sRGB curve and its inverse match IEC 61966-2-1") {
    const auto inputs = ramp_inputs(0.0, 1.0, 512);
    const auto encoded = run_glsl(
        "#include \"color.glsl\"\nvec4 f(vec4 x) { return vec4(srgb_encode(x.rgb), 1); }\n",
        inputs);
    const auto decoded = run_glsl(
        "#include \"color.glsl\"\nvec4 f(vec4 x) { return vec4(srgb_decode(x.rgb), 1); }\n",
        inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        CHECK(is_near(encoded[i][0], srgb_encode(inputs[i][0]), 2e-6));
        CHECK(is_near(decoded[i][1], srgb_decode(inputs[i][1]), 2e-6));
    }
    const Vec4 beyond = run_glsl(
        "#include \"color.glsl\"\n"
        "vec4 f(vec4 x) { return vec4(srgb_encode_unbounded(x.rgb), 1); }\n",
        Vec4{4.0, 1.0, 0.001, 1.0});
    CHECK(is_near(beyond[0], 1.055 * std::pow(4.0, 1.0 / 2.4) - 0.055, 1e-5));
    CHECK(is_near(beyond[1], 1.0, 1e-6));
    CHECK(is_near(beyond[2], 0.01292, 1e-6));
}

TEST_CASE("BT.1886 matches its published end points and midpoint, and has an inverse") {
    const auto lights = run_glsl(
        "#include \"color.glsl\"\nvec4 f(vec4 x) { return vec4("
        "bt1886_decode(vec3(x.x), 100.0, 0.1).x, bt1886_decode(vec3(x.x), 100.0, 0.0).x, "
        "bt1886_encode(bt1886_decode(vec3(x.x), 100.0, 0.1), 100.0, 0.1).x, 1.0); }\n",
        std::vector<Vec4>{{0.0}, {0.5}, {1.0}, {0.3}});
    CHECK(is_near(lights[0][0], 0.1, 1e-5));
    CHECK(is_near(lights[1][0], 21.605, 1e-3));
    CHECK(is_near(lights[2][0], 100.0, 1e-3));
    CHECK(is_near(lights[0][1], 0.0, 1e-6));
    CHECK(is_near(lights[1][1], 18.95, 5e-3));
    CHECK(is_near(lights[3][2], 0.3, 1e-5));
}

TEST_CASE("each tone map matches its published values") {
    struct Point {
        int curve;
        double light;
        double shown;
    };
    const std::vector<Point> table{
        {0, 0.7, 0.7},   {0, 2.0, 1.0},     {2, 0.18, 0.267}, {2, 1.0, 0.804},
        {2, 4.0, 0.973}, {3, 1.0, 0.53125}, {3, 4.0, 1.0},    {5, 0.18, 0.14},
        {5, 0.8, 0.76},  {5, 1.0, 0.8691},  {5, 4.0, 0.9833}, {6, 2.0, 2.0},
    };
    std::vector<Vec4> inputs;
    for (const Point& point : table)
        inputs.push_back(grey(point.light, point.curve));
    inputs.push_back({0.0, 4.0, 0.0, 5.0});
    const auto drawn = run_glsl(tone_maps, inputs);
    for (std::size_t i = 0; i < table.size(); ++i) {
        CAPTURE(table[i].curve);
        CAPTURE(table[i].light);
        CHECK(is_near(drawn[i][1], table[i].shown, 6e-4));
    }
    const Vec4 green{0.306, 0.983, 0.306, 1.0};
    for (std::size_t c = 0; c < 3; ++c)
        CHECK(is_near(drawn.back()[c], green[c], 1e-3));

    const Vec4 plain = run_glsl(
        "#include \"tonemap.glsl\"\nvec4 f(vec4 x) { return vec4(tone_mapped(x.rgb, 1, 0.0), 1); "
        "}\n",
        Vec4{2.5 * 1.5, 1.0, 0.0, 0.0});
    CHECK(is_near(plain[0], 0.7895, 1e-4));
    CHECK(is_near(plain[1], 0.5, 1e-6));
}

TEST_CASE("AgX matches its published curve") {
    constexpr int count = 257;
    std::vector<Vec4> inputs;
    for (int i = 0; i < count; ++i)
        inputs.push_back(grey(std::exp2(-12.47393 + 16.5 * i / (count - 1)), 4));
    inputs.push_back(grey(0.18, 4));
    const auto drawn = run_glsl(tone_maps, inputs);
    double squares = 0.0;
    for (int i = 0; i < count; ++i) {
        const double shown = std::pow(drawn[static_cast<std::size_t>(i)][0], 1.0 / 2.2);
        squares += std::pow(shown - agx_polynomial(i / (count - 1.0)), 2.0);
    }
    CHECK(squares / count < 1e-5);
    CHECK(is_near(std::pow(drawn.back()[0], 1.0 / 2.2), 0.5, 2e-3));  // the pivot of the curve
}

TEST_CASE("every tone map rises from black to 1 and keeps grey neutral") {
    constexpr int count = 200;
    std::vector<Vec4> inputs;
    for (int curve = 0; curve < 6; ++curve)
        for (int i = 0; i < count; ++i)
            inputs.push_back(grey(i == 0 ? 0.0 : std::exp2(-12.0 + 18.0 * i / count), curve));
    const auto drawn = run_glsl(tone_maps, inputs);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        CAPTURE(inputs[i][3]);
        CAPTURE(inputs[i][0]);
        const bool is_first = i % count == 0;
        CHECK(drawn[i][0] >= (is_first ? 0.0 : drawn[i - 1][0] - 1e-6));
        CHECK(drawn[i][0] <= (is_first ? 0.002 : 1.0));
        const double spread = std::max(drawn[i][1], drawn[i][2]) - drawn[i][0];
        CHECK(is_near(spread, 0.0, 0.5 / 255.0));
    }
}

TEST_CASE("the barrel distortion keeps the centres of the sides and can be inverted") {
    std::vector<Vec4> inputs;
    for (int i = 0; i < 41; ++i)
        for (int j = 0; j < 41; ++j)
            inputs.push_back({-1.0 + i / 20.0, -1.0 + j / 20.0, 0.0, 0.0});
    for (const double curvature : {0.0, 0.08, 0.5}) {
        CAPTURE(curvature);
        for (Vec4& input : inputs)
            input[2] = curvature;
        const auto forth_and_back = run_glsl(
            "#include \"barrel.glsl\"\nvec4 f(vec4 x) { return vec4("
            "barrel_radial_inverse(barrel_radial(x.xy, x.z), x.z), "
            "barrel_radial(barrel_radial_inverse(x.xy, x.z), x.z)); }\n",
            inputs);
        double worst = 0.0;
        for (std::size_t i = 0; i < inputs.size(); ++i)
            for (std::size_t axis = 0; axis < 4; ++axis)
                worst = std::max(worst, std::abs(forth_and_back[i][axis] - inputs[i][axis % 2]));
        CHECK(worst < 1e-6);
    }
    const auto bent = run_glsl(
        "#include \"barrel.glsl\"\n"
        "vec4 f(vec4 x) { return vec4(barrel_radial(x.xy, 0.08), 0, 0); }\n",
        std::vector<Vec4>{{1, 0}, {0, -1}, {0.001, 0}, {1, 1}, {0.5, 0.25}});
    CHECK(is_near(bent[0][0], 1.0, 1e-6));
    CHECK(is_near(bent[1][1], -1.0, 1e-6));
    CHECK(is_near(bent[2][0], 0.00092, 1e-8));
    CHECK(is_near(bent[3][0], 1.08, 1e-6));
    CHECK(is_near(bent[4][0] / bent[4][1], 2.0, 1e-5));  // lines through the centre stay straight
}

TEST_CASE("scanlines keep their mean at every period, and their depth follows a closed form") {
    constexpr const char* body =
        "#include \"glass.glsl\"\n"
        "vec4 f(vec4 x) { return vec4(scanline_factor(x.x, x.y, 0.3)); }\n";
    const std::vector<double> periods{4.0, 4.5, 3.0, 2.25};
    std::vector<Vec4> inputs;
    for (const double period : periods)
        for (int y = 0; y < 36; ++y)
            inputs.push_back({y + 0.5, period, 0.0, 0.0});
    inputs.push_back({3.0, 4.0, 0.0, 0.0});
    const auto rows = run_glsl(body, inputs);
    for (std::size_t i = 0; i < periods.size(); ++i) {
        CAPTURE(periods[i]);
        double mean = 0.0;
        for (std::size_t y = 0; y < 36; ++y)
            mean += rows[36 * i + y][0] / 36.0;
        CHECK(is_near(mean, 0.85, 0.85 * 0.0005));
    }
    // The mean over a pixel reduces a sine of period p by sin(pi / p) / (pi / p).
    const double quarter = std::acos(-1.0) / 4.0;
    CHECK(is_near(rows.back()[0], 0.85 + 0.15 * std::sin(quarter) / quarter, 1e-5));
}

TEST_CASE("the noise is PCG3D, uniform and without bias") {
    const std::string body =
        "#include \"noise.glsl\"\nvec4 f(vec4 x) { return vec4(noise(uvec2(x.xy), uint(x.z)), 1); "
        "}\n";
    std::vector<Vec4> inputs;
    for (unsigned y = 0; y < 128; ++y)
        for (unsigned x = 0; x < 128; ++x)
            inputs.push_back({static_cast<double>(x), static_cast<double>(y), 7.0, 0.0});
    const auto drawn = run_glsl(body, inputs);
    std::size_t same = 0;
    double mean = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const auto expected = pcg3d({static_cast<std::uint32_t>(inputs[i][0]),
                                     static_cast<std::uint32_t>(inputs[i][1]), 7u});
        for (std::size_t c = 0; c < 3; ++c)
            same += drawn[i][c] == static_cast<double>(expected[c] >> 8u) / 16777216.0 ? 1u : 0u;
        mean += drawn[i][0] / static_cast<double>(drawn.size());
        square += drawn[i][0] * drawn[i][0] / static_cast<double>(drawn.size());
    }
    CHECK(same == 3 * drawn.size());
    CHECK(is_near(mean, 0.5, 0.2 / 255.0 + 3.0 / std::sqrt(12.0 * 16384.0)));
    CHECK(is_near(std::sqrt(square - mean * mean), 1.0 / std::sqrt(12.0), 0.03 / std::sqrt(12.0)));
}

TEST_CASE("dither makes levels between 8-bit steps visible") {
    std::vector<Vec4> inputs;
    for (int level = 0; level < 16; ++level)
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                inputs.push_back({(100.0 + level / 16.0) / 255.0, static_cast<double>(x),
                                  static_cast<double>(y), 0.0});
    const auto drawn = run_glsl(
        "#include \"noise.glsl\"\n"
        "vec4 f(vec4 x) { return vec4(dithered(vec3(x.x), uvec2(x.yz), 3u), 1.0); }\n",
        inputs);
    for (std::size_t level = 0; level < 16; ++level) {
        double mean = 0.0;
        for (std::size_t i = 0; i < 1024; ++i)
            mean += std::round(255.0 * drawn[1024 * level + i][1]) / 1024.0;
        CHECK(is_near(mean, 100.0 + static_cast<double>(level) / 16.0, 0.1));
    }
}

TEST_CASE("with hue kept, the tone map applies to the brightest channel and scales the others") {
    const auto drawn = run_glsl(
        "#include \"tonemap.glsl\"\n"
        "vec4 f(vec4 x) { return vec4(tone_mapped_keeping_hue(x.rgb, int(x.w), 0.0), 1.0); }\n",
        std::vector<Vec4>{{4.0, 2.0, 1.0, 0.0}, {1.0, 4.0, 2.0, 1.0}, {0.0, 0.0, 0.0, 1.0}});
    const Vec4 expected[] = {{1.0, 0.5, 0.25}, {0.2, 0.8, 0.4}, {}};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            CHECK(is_near(drawn[i][c], expected[i][c], 1e-5));
}
