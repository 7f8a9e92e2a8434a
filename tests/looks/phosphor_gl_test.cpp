// Phosphor compared with closed forms: numeric values of its passes.
#include "about.h"
#include "looks/tube.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

namespace fs = std::filesystem;

TEST_CASE("a decay of 0.95 per 1/60 s leaves 0.0461 after a second") {
    Tube tube({{"decay", Value(0.95)}, {"beam_gain", Value(0.01)}});
    tube.draw({{0.0f, 0.0f, 1.0f, 0.0f}});
    const double before = tube.sum("persistence");
    CHECK(before == about(tube.sum("beam"), 1e-5));  // all light of the beam is stored
    tube.rest(60);
    CHECK(tube.sum("persistence") / before == about(std::pow(0.95, 60), 0.001));
    CHECK(std::pow(0.95, 60) == about(0.0461, 0.001));
}

TEST_CASE("a decay of 0.999 per 1/60 s gives the same light after 10 s at every frame rate") {
    for (const int fps : {24, 60, 144, 240}) {
        CAPTURE(fps);
        Tube tube({{"decay", Value(0.999)}, {"beam_gain", Value(0.01)}}, {16, 16});
        tube.draw({{0.0f, 0.0f, 1.0f, 0.0f}}, fps);
        const double before = tube.sum("persistence");
        tube.rest(10 * fps, fps);
        CHECK(tube.sum("persistence") / before == about(std::pow(0.999, 600), 0.01));
    }
}

TEST_CASE("light drawn in a frame has decayed by its age at the end of the frame") {
    Tube fresh({{"decay", Value(0.9)}, {"beam_gain", Value(0.01)}});
    fresh.draw({{0.0f, 0.0f, 1.0f, 0.0f}});
    Tube aged({{"decay", Value(0.9)}, {"beam_gain", Value(0.01)}});
    aged.draw({{0.0f, 0.0f, 1.0f, 0.5f / 60.0f}});
    CHECK(aged.sum("persistence") / fresh.sum("persistence") == about(std::sqrt(0.9), 0.0001));
}

TEST_CASE("a uniform deposit leaves E (1 - d^(60 dt)) / (-60 ln d)") {
    // 4096 points in a frame of 1/24 s, with a total charge of one unit per second.
    constexpr int count = 4096;
    constexpr double seconds = 1.0 / 24.0;
    constexpr double decay = 0.8;
    Beam beam;
    for (int i = 0; i < count; ++i)
        beam.push_back({0.0f, 0.0f, static_cast<float>(seconds / count),
                        static_cast<float>((i + 0.5) * seconds / count)});
    Tube tube({{"decay", Value(decay)}});
    tube.draw(beam, 24.0);
    Tube unit({{"decay", Value(decay)}});
    unit.draw({{0.0f, 0.0f, 1.0f, 0.0f}}, 24.0);
    const double expected = (1.0 - std::pow(decay, 60.0 * seconds)) / (-60.0 * std::log(decay));
    CHECK(tube.sum("persistence") / unit.sum("persistence") == about(expected, 0.001));
}

TEST_CASE("a static trace looks the same at 24, 48 and 144 fps") {
    const auto persistence_at = [](int fps) {
        auto roots = find_roots(fs::path(AFTERGLOW_SOURCE_DIR));
        REQUIRE(roots.has_value());
        RenderRequest request;
        request.look = "phosphor";
        request.values = {{"ceiling", "1000"}};
        request.signal = "lissajous:x=3,y=2";
        auto offline = Offline::create(*prepare(request, Library(*roots)), {256, 144}, fps);
        REQUIRE(offline.has_value());
        while (offline->frame_number() < fps / 4)
            offline->advance();
        return offline->picture(*find_pass(offline->executor().look(), "persistence"));
    };
    const Picture reference = persistence_at(48);
    const float peak = *std::max_element(reference.pixels.begin(), reference.pixels.end());
    CHECK(peak > 0.5f);
    for (const int fps : {24, 144}) {
        CAPTURE(fps);
        const Picture other = persistence_at(fps);
        float apart = 0.0f;
        for (std::size_t i = 0; i < other.pixels.size(); ++i)
            apart = std::max(apart, std::abs(other.pixels[i] - reference.pixels[i]));
        CHECK(apart <= peak / 255.0f);
    }
}

TEST_CASE("a point has the stated energy at every subpixel position") {
    for (const double width : {1.0, 2.0, 6.0}) {
        for (const float shift : {0.0f, 0.25f, 0.5f}) {
            CAPTURE(width);
            CAPTURE(shift);
            Tube tube({{"beam_width", Value(width)}, {"ceiling", Value(1000.0)}}, {256, 256});
            const float px = 2.0f / 256.0f;
            tube.draw({{shift * px, 0.3f * shift * px, 1.0f, 0.0f}});
            const double scaled = width * 256.0 / 512.0;
            const double energy =
                0.7 * scaled * scaled * std::numbers::pi * (1.0 / 28.0 + 0.3 / 8.0);
            CHECK(tube.sum("beam") == about(energy, 0.01));  // green is 1
            CHECK(tube.sum("beam", 0) == about(0.2 * energy, 0.01));
        }
    }
}

TEST_CASE("the bloom keeps the energy of a single lit spot") {
    Tube tube({}, {256, 256});
    for (const double size : {0.5, 1.0, 0.25}) {
        CAPTURE(size);
        tube.restart({{"bloom_kind", Value(0.0)},
                      {"beam_width", Value(2.0)},
                      {"ceiling", Value(1000.0)},
                      {"bloom_size", Value(size)}});
        tube.draw({{0.1f, -0.2f, 1.0f, 0.0f}});
        const double pixels_per_texel = 1.0 / (size * size);
        CHECK(tube.target("bloom_y").extent.width == 256 * size);
        CHECK(tube.sum("bloom_x") * pixels_per_texel == about(tube.sum("persistence"), 0.01));
        CHECK(tube.sum("bloom_y") * pixels_per_texel == about(tube.sum("persistence"), 0.01));
    }
}

TEST_CASE("the bloom has the stated sigma at any resolution") {
    Tube tube({}, {512, 512});
    for (const double size : {0.5, 0.25}) {
        CAPTURE(size);
        tube.restart({{"bloom_kind", Value(0.0)},
                      {"bloom_radius", Value(3.0)},
                      {"bloom_sigma", Value(1.64)},
                      {"bloom_taps", Value(25.0)},
                      {"bloom_size", Value(size)},
                      {"ceiling", Value(1000.0)},
                      {"beam_width", Value(1.0)}});
        const float centre = 1.0f / 512.0f;
        tube.draw({{centre, centre, 1.0f, 0.0f}});
        const Picture bloom = tube.target("bloom_y");
        double sum = 0.0;
        double squares = 0.0;
        double mean = 0.0;
        for (int y = 0; y < bloom.extent.height; ++y)
            for (int x = 0; x < bloom.extent.width; ++x) {
                const auto light = static_cast<double>(bloom.pixels[bloom.index(x, y) + 1]);
                sum += light;
                mean += light * x;
                squares += light * x * x;
            }
        mean /= sum;
        const double sigma = std::sqrt(squares / sum - mean * mean) * 0.5 / size;
        CHECK(sigma == about(1.64 * 3.0, 0.03));  // half-size px at 512 lines
    }
}

TEST_CASE("the phosphor saturates at its ceiling and keeps its hue") {
    Tube tube({{"ceiling", Value(2.5)}, {"beam_width", Value(16.0)}});
    tube.draw(tube.flood());
    CHECK(tube.at("reduced", 32, 32, 1) == about(2.5, 1e-5));
    CHECK(tube.at("reduced", 32, 32, 0) == about(0.5, 1e-4));
    Tube red({{"ceiling", Value(2.5)},
              {"beam_width", Value(16.0)},
              {"beam_color", Value(std::vector<double>{1, 0.2, 0})}});
    red.draw(red.flood());
    CHECK(red.at("reduced", 32, 32, 0) == about(2.5, 1e-5));
    CHECK(red.at("reduced", 32, 32, 1) == about(0.5, 1e-4));
}

TEST_CASE("Reinhard of 2.5 at an exposure of 1.5 is 0.7895") {
    Tube tube(plain_glass());
    tube.draw(tube.flood());
    CHECK(tube.at("composite", 64, 64) == about(3.75 / 4.75, 1e-4));
    CHECK(3.75 / 4.75 == about(0.7895, 1e-4));
}

TEST_CASE("display encoding is the piecewise sRGB curve, applied once") {
    Tube tube(with(plain_glass(), {{"display_encode", Value(1.0)}}));
    tube.draw(tube.flood());
    CHECK(tube.at("composite", 64, 64) ==
          about(1.055 * std::pow(3.75 / 4.75, 1.0 / 2.4) - 0.055, 1e-4));
}

TEST_CASE("display encoding is linear near black") {
    Tube tube(with(
        plain_glass(),
        {{"display_encode", Value(1.0)}, {"tone_map", Value(0.0)}, {"exposure", Value(0.0008)}}));
    tube.draw(tube.flood());
    CHECK(tube.at("composite", 64, 64) == about(12.92 * 2.5 * 0.0008, 1e-4));
}

TEST_CASE("the tone maps match their papers") {
    const auto shown = [](const Values& values) {
        Tube tube(with(plain_glass(), values));
        tube.draw(tube.flood());
        return tube.at("composite", 64, 64);
    };
    const auto light = 1.5 * 2.5;
    CHECK(shown({{"white", Value(5.0)}}) ==
          about(light * (1.0 + light / 25.0) / (1.0 + light), 1e-4));
    CHECK(shown({{"tone_map", Value(2.0)}, {"exposure", Value(0.4)}}) ==
          about((2.51 + 0.03) / (2.43 + 0.59 + 0.14), 1e-4));  // for a light of 1
    CHECK(shown({{"tone_map", Value(0.0)}, {"exposure", Value(0.1)}}) == about(0.25, 1e-4));
}

TEST_CASE("hue is kept when only the brightest channel is tone mapped") {
    for (const double keep : {0.0, 1.0}) {
        CAPTURE(keep);
        Tube tube(with(plain_glass(), {{"keep_hue", Value(keep)},
                                       {"beam_color", Value(std::vector<double>{0.2, 1, 0.3})}}));
        tube.draw(tube.flood());
        const double red = keep == 1.0 ? 0.2 * 3.75 / 4.75 : 0.75 / 1.75;
        CHECK(tube.at("composite", 64, 64, 0) == about(red, 1e-4));
    }
}

TEST_CASE("bloom is added to the trace in linear light") {
    Tube tube(with(
        plain_glass(),
        {{"bloom_intensity", Value(0.5)}, {"tone_map", Value(0.0)}, {"exposure", Value(0.1)}}));
    tube.draw(tube.flood());
    CHECK(tube.at("composite", 64, 64) == about(0.1 * 2.5 * 1.5, 1e-4));
}

TEST_CASE("a vignette darkens the corners by its strength, and curvature moves them outwards") {
    const auto kept = [](double curvature, int x, int y) {
        Tube flat(plain_glass());
        flat.draw(flat.flood());
        Tube dark(with(plain_glass(), {{"vignette", Value(0.8)}, {"curvature", Value(curvature)}}));
        dark.draw(dark.flood());
        return dark.at("composite", x, y) / flat.at("composite", 64, 64);
    };
    const double edge = 127.0 / 128.0;  // the centre of the last pixel; the glass ends at 1
    CHECK(kept(0.0, 127, 127) == about(1.0 - 0.8 * edge * edge, 1e-3));
    const double place = 95.5 / 64.0 - 1.0;  // of pixel 95, also in y
    const double moved = place * (1.0 + 0.3 * 40.0 / 36.0 * place * place);
    CHECK(kept(0.3, 95, 32) == about(1.0 - 0.8 * moved * moved, 1e-4));
}

TEST_CASE("scanlines leave a mean of 1 - strength / 2 over whole periods") {
    for (const double period : {4.0, 8.0}) {
        CAPTURE(period);
        Tube flat(plain_glass());
        flat.draw(flat.flood());
        Tube lined(with(plain_glass(),
                        {{"scanline_strength", Value(0.3)}, {"scanline_period", Value(period)}}));
        lined.draw(lined.flood());
        CHECK(lined.sum("composite") / flat.sum("composite") == about(0.85, 0.005));
        constexpr double pi = std::numbers::pi;
        const double up = 128.0 - 61.5;  // px from the bottom to the centre of row 61
        const double pixel = std::sin(pi / period) / (pi / period);  // mean of a sine over a pixel
        CHECK(lined.at("composite", 64, 61) / flat.at("composite", 64, 61) ==
              about(1.0 - 0.3 * (0.5 + 0.5 * std::sin(2.0 * pi * up / period) * pixel), 1e-4));
    }
}

namespace {
/// Includes brightness above 1.
Beam trace_of_all_brightnesses() {
    Beam beam{{0.99f, 0.99f, 20.0f, 0.0f}};  // in the corner
    for (int i = 0; i < 200; ++i) {
        const float turn = static_cast<float>(i) / 200.0f;
        beam.push_back({0.9f * std::sin(6.2832f * 3 * turn), 0.8f * std::sin(6.2832f * 2 * turn),
                        80.0f * turn, 0.0f});
    }
    return beam;
}

Values all_off() {
    return with(plain_glass(), {{"beam_color", Value(std::vector<double>{0.2, 1, 0.6})},
                                {"tone_map", Value(0.0)},
                                {"exposure", Value(1.0)},
                                {"keep_hue", Value(0.0)},
                                {"ceiling", Value(1000.0)}});
}

/// The difference of the picture from the phosphor's light, clipped at 1.
double distance_from_copy(const Tube& tube) {
    const Picture light = tube.target("persistence");
    const Picture shown = tube.target("composite");
    double apart = 0;
    for (std::size_t i = 0; i < light.pixels.size(); ++i)
        apart = std::max(apart, std::abs(static_cast<double>(std::min(light.pixels[i], 1.0f)) -
                                         static_cast<double>(shown.pixels[i])));
    return apart;
}
}  // namespace

TEST_CASE("with every stage off the picture is the phosphor's light, at any size") {
    for (const Extent extent : {Extent{128, 72}, Extent{149, 83}, Extent{50, 301}}) {
        CAPTURE(extent.width);
        Tube tube(all_off(), extent);
        tube.draw(trace_of_all_brightnesses());
        CHECK(tube.sum("persistence") > 10.0);
        CHECK(distance_from_copy(tube) == 0.0);
    }
}

TEST_CASE("each stage alone changes the picture") {
    const Values stages{
        {"bloom_intensity", Value(0.6)}, {"scanline_strength", Value(0.3)},
        {"graticule", Value(0.15)},      {"vignette", Value(0.3)},
        {"curvature", Value(0.04)},      {"aberration", Value(1.0)},
        {"corner_radius", Value(0.2)},   {"ambient_glass", Value(std::vector<double>{0, 0.003, 0})},
        {"dither", Value(1.0)},          {"display_encode", Value(1.0)},
        {"tone_map", Value(1.0)},        {"exposure", Value(1.5)},
        {"keep_hue", Value(0.8)}};
    Tube tube(all_off(), {149, 83});
    for (const auto& stage : stages) {
        CAPTURE(stage.first);
        tube.restart(with(all_off(), {stage}));
        tube.draw(trace_of_all_brightnesses());
        CHECK(distance_from_copy(tube) > 0.0005);
    }
}
