// The shadow mask compared with closed forms: transmitted light, sampling positions and loss.
#include "lab/offline/offline.h"
#include "looks/shadow_mask.h"
#include "model/look/color.h"
#include "signals/patterns/patterns.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace shadow_mask;

namespace {
/// A single pixel of linear light 1 in the middle of a black picture.
Picture lit_dot(Extent extent) {
    Picture picture = flat_field(extent, 0.0f, 0.0f, 0.0f);
    const auto middle = picture.index(extent.width / 2, extent.height / 2);
    for (std::size_t c = 0; c < 3; ++c)
        picture.pixels[middle + c] = 1.0f;
    return picture;
}
}  // namespace

TEST_CASE("shadow-mask with all stages off copies its source") {
    const auto source = make_pattern("harbour");
    const Picture drawn = drawn_look("shadow-mask", *source, stages_off());
    int different = 0;
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                different += std::lround(255.0 * number(drawn, x, y, c)) !=
                             std::lround(255.0 * number(*source, x, y, c));
    CHECK(different == 0);
}

TEST_CASE("without a tone map, light above 1 is passed on") {
    const Picture drawn =
        drawn_look("shadow-mask", flat_field({8, 8}, 3.0f, 3.0f, 3.0f), stages_off());
    CHECK(std::abs(number(drawn, 4, 4) - (1.055 * std::pow(3.0, 1.0 / 2.4) - 0.055)) < 1e-4);
}

TEST_CASE("the stripes of a cell have the chosen order") {
    const Picture white = flat_field({24, 12}, 1.0f, 1.0f, 1.0f);
    for (const std::size_t order : {0u, 1u}) {
        const Picture light =
            drawn_look("shadow-mask", white,
                       with(stages_off(), {{"mask_strength", Value(1.0)},
                                           {"mask_size", Value(12.0)},
                                           {"subpixel_order", Value(static_cast<double>(order))}}),
                       "tube");
        for (std::size_t stripe = 0; stripe < 3; ++stripe)
            for (std::size_t c = 0; c < 3; ++c) {
                const bool is_lit = c == (order == 0 ? stripe : 2 - stripe);
                CHECK((number(light, 12 + 4 * static_cast<int>(stripe) + 1, 3, c) > 0.5) == is_lit);
            }
    }
}

TEST_CASE("scanlines are horizontal or vertical, counted from the bottom left") {
    const Picture white = flat_field({8, 8}, 1.0f, 1.0f, 1.0f);
    for (const double axis : {0.0, 1.0}) {
        const Picture light = drawn_look(
            "shadow-mask", white,
            with(stages_off(), {{"scanline_strength", Value(0.6)}, {"scanline_axis", Value(axis)}}),
            "tube");
        const double quarter = std::acos(-1.0) / 2.0;
        for (int i = 0; i < 8; ++i) {
            const double mean = (std::cos(quarter * i) - std::cos(quarter * (i + 1))) / quarter;
            const double expected = (0.7 - 0.3 * mean) / 0.7;
            for (const int other : {1, 4}) {
                const bool is_across = axis == 0.0;
                CHECK(std::abs(number(light, is_across ? other : i, is_across ? 7 - i : other) -
                               expected) < 1e-4);
            }
        }
    }
}

TEST_CASE(
    "scanlines of source lines scale with the picture size on the glass, and may be vertical") {
    const Picture white = flat_field({12, 24}, 1.0f, 1.0f, 1.0f);
    const Values lines = with(stages_off(), {{"scanline_unit", Value(1.0)},
                                             {"scanline_strength", Value(0.6)},
                                             {"scanline_interlace", Value(0.0)},
                                             {"brightness_kept", Value(0.0)}});
    const auto expected = [](double place, double period) {  // a crest at the centre of each line
        const double angle = std::acos(-1.0) / period;
        return 0.7 - 0.3 * std::cos(2.0 * angle * place) * std::sin(angle) / angle;
    };
    const Picture across = drawn_look_at("shadow-mask", {48, 96}, white, lines, 1, "tube");
    const Picture larger = drawn_look_at("shadow-mask", {48, 96}, white,
                                         with(lines, {{"picture_size", Value(1.25)}}), 1, "tube");
    const Picture down = drawn_look_at("shadow-mask", {48, 96}, white,
                                       with(lines, {{"scanline_axis", Value(1.0)}}), 1, "tube");
    for (int i = 0; i < 48; ++i) {
        CHECK(std::abs(number(across, 5, i) - expected(i + 0.5, 4.0)) < 2e-4);
        CHECK(std::abs(number(larger, 5, i) - expected(i + 0.5 + 12.0, 5.0)) < 2e-4);
        CHECK(std::abs(number(down, i, 5) - expected(i + 0.5, 4.0)) < 2e-4);
    }
}

TEST_CASE("the number of triads sets the mask size, and snapping rounds it") {
    const Picture white = flat_field({120, 60}, 1.0f, 1.0f, 1.0f);
    const auto masked = [&white](const Values& values) {
        return drawn_look("shadow-mask", white,
                          with(with(stages_off(), {{"mask_strength", Value(1.0)}}), values),
                          "tube");
    };
    const Picture six = masked({{"mask_size", Value(6.0)}});
    const Picture near_six = masked({{"mask_size", Value(6.3)}});
    CHECK(six.pixels != near_six.pixels);
    CHECK(masked({{"mask_unit", Value(1.0)}, {"mask_triads", Value(20.0)}}).pixels == six.pixels);
    CHECK(masked({{"mask_size", Value(6.3)}, {"mask_snap", Value(1.0)}}).pixels == six.pixels);
    CHECK(
        masked({{"mask_unit", Value(1.0)}, {"mask_triads", Value(19.0)}, {"mask_snap", Value(1.0)}})
            .pixels == six.pixels);  // 6.32 px
    CHECK(masked({{"mask_unit", Value(1.0)}, {"mask_triads", Value(19.0)}}).pixels != six.pixels);
}

TEST_CASE("the mean over whole cells equals that of the picture, in every channel of every mask") {
    const Picture grey = flat_field({120, 104}, 0.2f, 0.2f, 0.2f);
    for (const double type : {0.0, 1.0, 2.0, 3.0}) {
        CAPTURE(type);
        const Picture light = drawn_look("shadow-mask", grey,
                                         with(stages_off(), {{"mask_strength", Value(1.0)},
                                                             {"mask_type", Value(type)},
                                                             {"mask_size", Value(12.0)}}),
                                         "tube");
        // 104 px are ten half rows of dots and 8 2/3 cells; the cells use 96 px.
        for (std::size_t c = 0; c < 3; ++c)
            CHECK(std::abs(mean_of(light, c, 0, 0, {120, type == 3.0 ? 104 : 96}) - 0.2) <
                  0.2 * 0.005);
    }
}

TEST_CASE("a mask without brightness compensation only removes light") {
    const Picture white = flat_field({48, 48}, 1.0f, 1.0f, 1.0f);
    for (const double type : {0.0, 1.0, 2.0, 3.0}) {
        CAPTURE(type);
        const Picture light = drawn_look("shadow-mask", white,
                                         with(stages_off(), {{"mask_strength", Value(1.0)},
                                                             {"mask_type", Value(type)},
                                                             {"mask_size", Value(24.0)},
                                                             {"brightness_kept", Value(0.0)}}),
                                         "tube");
        double brightest = 0.0;
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 48; ++x)
                brightest = std::max(brightest, number(light, x, y));
        CHECK(brightest <= 1.0 + 1e-4);
        CHECK(brightest > 0.9);
    }
}

TEST_CASE("every cell shows the picture at its centre, also in staggered columns") {
    // A vertical ramp: light is the height, row 0 is the top.
    Picture ramp = flat_field({24, 48}, 0.0f, 0.0f, 0.0f);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 24; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                ramp.pixels[ramp.index(x, y) + c] = (48.0f - static_cast<float>(y) - 0.5f) / 48.0f;
    for (const double stagger : {0.5, 0.25, 0.0}) {
        CAPTURE(stagger);
        const Picture cells = drawn_look("shadow-mask", ramp,
                                         with(stages_off(), {{"sampling", Value(0.0)},
                                                             {"mask_size", Value(12.0)},
                                                             {"mask_stagger", Value(stagger)}}),
                                         "tube");
        for (int y = 0; y < 48; ++y) {
            const double up = (48 - y - 0.5) / 12.0;  // cells
            CHECK(std::abs(number(cells, 5, y) - (std::floor(up) + 0.5) / 4.0) < 1e-4);
            const double other = std::floor(up + stagger) + 0.5 - stagger;
            if (y >= 6 && y < 42)
                CHECK(std::abs(number(cells, 17, y) - other / 4.0) < 1e-4);
        }
    }
}

TEST_CASE("each channel is read at its own offset, right and up") {
    const Picture light = drawn_look("shadow-mask", lit_dot({32, 16}),
                                     with(stages_off(), {{"red_offset", point(3, 0)},
                                                         {"green_offset", point(-2, 1)},
                                                         {"blue_offset", point(0, -4)}}),
                                     "tube");
    CHECK(std::abs(number(light, 16 - 3, 8, 0) - 1.0) < 1e-3);
    CHECK(std::abs(number(light, 16 + 2, 8 + 1, 1) - 1.0) < 1e-3);
    CHECK(std::abs(number(light, 16, 8 - 4, 2) - 1.0) < 1e-3);
    CHECK(number(light, 16, 8, 1) < 1e-3);
}

TEST_CASE("the bloom of a dot has the dot's energy and the set width") {
    const Picture bloom = drawn_look("shadow-mask", lit_dot({192, 192}), stages_off(), "bloom_y");
    double sum = 0.0;
    double spread = 0.0;
    for (int y = 0; y < bloom.extent.height; ++y)
        for (int x = 0; x < bloom.extent.width; ++x) {
            sum += 4.0 * number(bloom, x, y);  // each texel is four pixels of the picture
            spread += 4.0 * number(bloom, x, y) * std::pow(2.0 * (x - 48.0), 2.0);
        }
    CHECK(std::abs(sum - 1.0) < 0.01);
    // 6 px of 512 are 2.25 of 192.
    CHECK(std::abs(std::sqrt(spread / sum) - 2.25) < 0.03 * 2.25);
}

TEST_CASE("a curved screen shows the border colour beyond its corners, and is symmetric") {
    const Picture white = flat_field({96, 54}, 1.0f, 1.0f, 1.0f);
    const Picture drawn = drawn_look(
        "shadow-mask", white,
        with(stages_off(), {{"curvature", Value(0.2)},
                            {"vignette_depth", Value(1.0)},
                            {"border_color", Value(std::vector<double>{0.25, 0.5, 0.125})}}));
    for (const int x : {0, 95})
        for (const int y : {0, 53}) {
            CHECK(std::abs(number(drawn, x, y, 0) - srgb_encode(0.25)) < 1e-4);
            CHECK(std::abs(number(drawn, x, y, 2) - srgb_encode(0.125)) < 1e-4);
        }
    double worst = 0.0;
    for (int y = 0; y < 54; ++y)
        for (int x = 0; x < 96; ++x) {
            worst = std::max(worst, std::abs(number(drawn, x, y) - number(drawn, 95 - x, y)));
            worst = std::max(worst, std::abs(number(drawn, x, y) - number(drawn, x, 53 - y)));
        }
    CHECK(worst < 1e-3);
}

TEST_CASE("a smaller picture leaves a black border on the glass, and a larger one is cropped") {
    Picture ramp = flat_field({32, 16}, 0.0f, 0.0f, 0.0f);
    for (std::size_t i = 0; i < ramp.pixels.size(); ++i)
        ramp.pixels[i] = (static_cast<float>(i / 3 % 32) + 0.5f) / 32.0f;
    for (const double size : {0.5, 2.0}) {
        CAPTURE(size);
        const Picture light = drawn_look(
            "shadow-mask", ramp, with(stages_off(), {{"picture_size", Value(size)}}), "tube");
        for (const int x : {9, 14, 20, 22})
            CHECK(std::abs(number(light, x, 8) - ((x + 0.5 - 16.0) / size + 16.0) / 32.0) < 1e-5);
        CHECK((number(light, 5, 8) == 0.0) == (size < 1.0));
        CHECK((number(light, 16, 2) == 0.0) == (size < 1.0));
    }
}

TEST_CASE("vignette and pulse follow their formulas") {
    const Picture white = flat_field({64, 36}, 1.0f, 1.0f, 1.0f);
    const Picture light = drawn_look(
        "shadow-mask", white,
        with(stages_off(), {{"vignette_depth", Value(0.5)}, {"pulse_intensity", Value(0.05)}}),
        "tube");
    for (const int x : {0, 20, 50})
        for (const int y : {3, 18}) {
            const double u = (x + 0.5) / 32.0 - 1.0;
            const double v = (y + 0.5) / 18.0 - 1.0;
            const double dark = std::pow((1.0 - u * u) * (1.0 - v * v), 0.4);
            const double expected = (0.5 + 0.5 * dark) * (1.0 + 0.05 * std::cos((x + 0.5) / 60.0));
            CHECK(std::abs(number(light, x, y) - expected) < 1e-4);
        }
}

TEST_CASE("the pulse is averaged over each frame") {
    auto roots = find_roots(std::filesystem::path(AFTERGLOW_SOURCE_DIR));
    REQUIRE(roots.has_value());
    RenderRequest request{.look = "shadow-mask", .source = "pattern:white,size=64x8"};
    for (const auto& [name, value] : stages_off())
        request.values.emplace_back(name, to_string(value));
    request.values.emplace_back("pulse_intensity", "0.05");
    request.values.emplace_back("pulse_rate", "40");
    auto prepared = prepare(request, Library(std::move(*roots)));
    REQUIRE(prepared.has_value());
    auto offline = Offline::create(std::move(*prepared), {64, 8}, 10.0);
    REQUIRE(offline.has_value());
    for (const double begin : {0.0, 0.1, 0.2}) {
        offline->advance();
        const Picture tube = offline->picture(0);
        for (const int x : {2, 60}) {
            const double place = (x + 0.5) / 60.0;
            const double mean =
                (std::sin(place + 40.0 * (begin + 0.1)) - std::sin(place + 40.0 * begin)) / 4.0;
            CHECK(std::abs(number(tube, x, 4) - (1.0 + 0.05 * mean)) < 0.001);
        }
    }
}

TEST_CASE("a monochrome phosphor has one colour") {
    const Picture field = flat_field({48, 48}, 0.9f, 0.2f, 0.4f);
    const Picture light =
        drawn_look("shadow-mask", field,
                   with(stages_off(), {{"mask_strength", Value(1.0)},
                                       {"mask_size", Value(12.0)},
                                       {"monochrome", Value(1.0)},
                                       {"tint", Value(std::vector<double>{0.25, 1.0, 0.5})}}),
                   "tube");
    const double luminance = 0.2126 * 0.9 + 0.7152 * 0.2 + 0.0722 * 0.4;
    CHECK(std::abs(mean_of(light, 1, 0, 0, {48, 48}) - luminance) < 0.005 * luminance);
    for (int x = 0; x < 48; ++x) {
        CHECK(std::abs(number(light, x, 7, 0) - 0.25 * number(light, x, 7, 1)) < 1e-5);
        CHECK(std::abs(number(light, x, 7, 2) - 0.5 * number(light, x, 7, 1)) < 1e-5);
    }
}
