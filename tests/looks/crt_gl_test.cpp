// The crt look compared with closed forms: each stage alone, and all of them off.
#include "lab/offline/offline.h"
#include "looks/drawn_picture.h"
#include "model/look/color.h"
#include "signals/patterns/patterns.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
/// Each stage switched off separately.
Values stages_off() {
    return {{"aberration", Value(0.0)},
            {"tone_map", Value(6.0)},
            {"scanline_strength", Value(0.0)},
            {"dither", Value(0.0)}};
}

Values with(Values values, const Values& more) {
    for (const auto& [name, value] : more)
        values[name] = value;
    return values;
}

int code(float display) {
    return static_cast<int>(std::lround(std::clamp(display, 0.0f, 1.0f) * 255.0f));
}

int differing_codes(const Picture& drawn, const Picture& source) {
    int count = 0;
    for (int y = 0; y < source.extent.height; ++y)
        for (int x = 0; x < source.extent.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                count += code(drawn.pixels[drawn.index(x, y) + c]) !=
                         code(source.pixels[source.index(x, y) + c]);
    return count;
}

/// The linear light of a drawn pixel.
double light_at(const Picture& drawn, int x, int y, std::size_t channel = 1) {
    return srgb_decode(static_cast<double>(drawn.pixels[drawn.index(x, y) + channel]));
}

double mean_light(const Picture& drawn) {
    double sum = 0.0;
    for (int y = 0; y < drawn.extent.height; ++y)
        sum += light_at(drawn, 1, y) / drawn.extent.height;
    return sum;
}
}  // namespace

TEST_CASE("crt switched off copies its source, as does crt with all stages off") {
    for (const char* text : {"harbour", "checker,size=160x90"}) {
        CAPTURE(text);
        const auto source = make_pattern(text);
        REQUIRE(source.has_value());
        CHECK(differing_codes(drawn_look("crt", *source, {{"crt", Value(0.0)}}), *source) == 0);
        CHECK(differing_codes(drawn_look("crt", *source, stages_off()), *source) == 0);
    }
}

TEST_CASE("light above 1 is kept, also for the next look of a stack") {
    const Picture bright = flat_field({4, 4}, 7.5f, 1.25f, 0.5f);
    for (const Values& off : {Values{{"crt", Value(0.0)}}, stages_off()}) {
        const Picture drawn = drawn_look("crt", bright, off);
        const auto shown = [&drawn](std::size_t c) {
            return static_cast<double>(drawn.pixels[drawn.index(2, 2) + c]);
        };
        CHECK(std::abs(shown(0) - (1.055 * std::pow(7.5, 1.0 / 2.4) - 0.055)) < 1e-4);
        CHECK(std::abs(shown(1) - (1.055 * std::pow(1.25, 1.0 / 2.4) - 0.055)) < 1e-4);
        CHECK(std::abs(shown(2) - srgb_encode(0.5)) < 1e-4);
    }
    auto roots = find_roots(std::filesystem::path(AFTERGLOW_SOURCE_DIR));
    REQUIRE(roots.has_value());
    RenderRequest request{.look = "crt+crt", .source = "pattern:white"};
    for (const char* key : {"crt/", "crt#2/"})
        for (const auto& [name, value] : stages_off())
            request.values.emplace_back(key + name, std::to_string(value.number()));
    request.values.emplace_back("crt/exposure", "4");
    request.values.emplace_back("crt#2/exposure", "0.125");
    auto prepared = prepare(request, Library(std::move(*roots)));
    REQUIRE(prepared.has_value());
    auto offline = Offline::create(std::move(*prepared), {16, 16}, 60.0);
    REQUIRE(offline.has_value());
    offline->advance();
    CHECK(std::abs(light_at(offline->picture(), 8, 8) - 0.5) < 0.004);
}

TEST_CASE("a white dot splits into red and blue at the aberration's distance") {
    const auto source = make_pattern("dot,size=64x8");
    const Picture drawn =
        drawn_look("crt", *source, with(stages_off(), {{"aberration", Value(3.0)}}));
    for (std::size_t c = 0; c < 3; ++c) {
        const int expected = 32 + (static_cast<int>(c) - 1) * 3;
        for (int x = 0; x < 64; ++x)
            CHECK(std::abs(light_at(drawn, x, 4, c) - (x == expected ? 1.0 : 0.0)) < 1e-3);
    }
}

TEST_CASE("scanlines keep the mean light at every period, or darken by half their depth") {
    const Picture grey = flat_field({4, 72}, 0.4f, 0.4f, 0.4f);
    for (const double period : {3.0, 4.0, 4.5, 7.2}) {
        CAPTURE(period);
        const Values lines = with(
            stages_off(), {{"scanline_strength", Value(0.6)}, {"scanline_period", Value(period)}});
        CHECK(std::abs(mean_light(drawn_look("crt", grey, lines)) - 0.4) < 0.4 * 0.005);
        const Values dark = with(lines, {{"scanline_brightness", Value(0.0)}});
        CHECK(std::abs(mean_light(drawn_look("crt", grey, dark)) - 0.28) < 0.28 * 0.005);
    }
}

TEST_CASE("scanlines are the mean of the sine over each pixel") {
    const Picture field = flat_field({4, 8}, 1.0f, 1.0f, 1.0f);
    const Picture drawn = drawn_look("crt", field,
                                     with(stages_off(), {{"scanline_strength", Value(0.3)},
                                                         {"scanline_brightness", Value(0.0)}}));
    const double quarter = std::acos(-1.0) / 2.0;
    for (int y = 0; y < 8; ++y) {
        const double mean = (std::cos(quarter * y) - std::cos(quarter * (y + 1))) / quarter;
        CHECK(std::abs(light_at(drawn, 1, y) - (0.85 - 0.15 * mean)) < 1e-4);
    }
}

namespace {
constexpr double turn = 6.28318530717958648;

// The mean over pixel y of 1 - s (1 - cos(2 pi (y - crest) / period)) / 2, which is 1 at crests.
double stripe_mean(int y, double period, double crest, double strength) {
    const auto area = [&](double at) {
        return std::sin(turn * (at - crest) / period) * period / turn;
    };
    return 1.0 - 0.5 * strength * (1.0 - (area(y + 1.0) - area(y)));
}

Values by_source_lines(double interlace) {
    return with(stages_off(), {{"scanline_unit", Value(1.0)},
                               {"scanline_strength", Value(0.6)},
                               {"scanline_interlace", Value(interlace)},
                               {"scanline_brightness", Value(0.0)}});
}
}  // namespace

TEST_CASE("a scanline per source line has its crest at the centre of the line") {
    const Picture field = flat_field({4, 24}, 1.0f, 1.0f, 1.0f);
    for (const int height : {96, 72, 60}) {  // 4, 3 and 2.5 px per line
        CAPTURE(height);
        const double line = height / 24.0;
        const Picture drawn = drawn_look_at("crt", {4, height}, field, by_source_lines(0.0));
        const Picture pairs =
            drawn_look_at("crt", {4, height}, field,
                          with(by_source_lines(0.0), {{"scanline_lines", Value(2.0)}}));
        for (int y = 0; y < height; ++y) {
            CHECK(std::abs(light_at(drawn, 1, y) - stripe_mean(y, line, 0.5 * line, 0.6)) < 2e-4);
            CHECK(std::abs(light_at(pairs, 1, y) - stripe_mean(y, 2.0 * line, line, 0.6)) < 2e-4);
        }
    }
}

TEST_CASE("an interlaced source shows its even lines in one field and its odd lines in the next") {
    const Picture field = flat_field({4, 24}, 1.0f, 1.0f, 1.0f);
    for (const int number : {2, 3}) {  // ends of frames: 2/60 s, an even field, and 3/60 s
        CAPTURE(number);
        const double crest = 2.0 * (number % 2) + 1.0;  // the centre of line 0 or 1, of 2 px
        const Picture drawn = drawn_look_at("crt", {4, 48}, field, by_source_lines(2.0), number);
        for (int y = 0; y < 48; ++y)
            CHECK(std::abs(light_at(drawn, 1, y) - stripe_mean(y, 4.0, crest, 0.6)) < 2e-4);
    }
}

TEST_CASE("a source is interlaced automatically from 289 to 576 lines") {
    for (const int lines : {288, 289, 576, 577}) {
        CAPTURE(lines);
        const Picture field = flat_field({2, lines}, 1.0f, 1.0f, 1.0f);
        const Picture drawn = drawn_look_at("crt", {2, 2 * lines}, field, by_source_lines(1.0), 2);
        const bool is_interlaced = lines == 289 || lines == 576;
        const double period = is_interlaced ? 4.0 : 2.0;
        for (int y = 0; y < 8; ++y)
            CHECK(std::abs(light_at(drawn, 1, y) - stripe_mean(y, period, 1.0, 0.6)) < 2e-3);
    }
}

TEST_CASE("as written in the article, 4 px scanlines have two levels of the display value") {
    const Picture field = flat_field({4, 8}, 2.0f, 2.0f, 2.0f);
    const Picture drawn =
        drawn_look("crt", field, {{"as_written", Value(1.0)}, {"aberration", Value(0.0)}});
    const double wave = 0.15 * std::sqrt(0.5);  // 0.744 and 0.956
    for (int y = 0; y < 8; ++y) {
        const double expected = 0.85 + (y % 4 < 2 ? -wave : wave);
        CHECK(std::abs(static_cast<double>(drawn.pixels[drawn.index(1, y)]) - expected) < 1e-4);
    }
}

TEST_CASE("aberration precedes the tone map, and scanlines follow it") {
    Picture dot = flat_field({16, 8}, 0.0f, 0.0f, 0.0f);
    for (std::size_t c = 0; c < 3; ++c)
        dot.pixels[dot.index(8, 4) + c] = 4.0f;
    const Picture fringes = drawn_look(
        "crt", dot, with(stages_off(), {{"aberration", Value(3.0)}, {"tone_map", Value(5.0)}}));
    // Khronos neutral for a light of 4 in one channel.
    CHECK(std::abs(light_at(fringes, 5, 4, 0) - 0.983) < 1e-3);
    CHECK(std::abs(light_at(fringes, 5, 4, 1) - 0.306) < 1e-3);
    CHECK(std::abs(light_at(fringes, 11, 4, 2) - 0.983) < 1e-3);

    const Picture lines = drawn_look("crt", flat_field({4, 8}, 3.0f, 3.0f, 3.0f),
                                     with(stages_off(), {{"tone_map", Value(0.0)},
                                                         {"scanline_strength", Value(0.5)},
                                                         {"scanline_brightness", Value(0.0)}}));
    CHECK(std::abs(mean_light(lines) - 0.75) < 1e-4);
}

TEST_CASE("the chosen tone map is applied after the exposure") {
    const Picture field = flat_field({4, 4}, 1.25f, 1.25f, 1.25f);
    const Values reinhard = with(
        stages_off(), {{"tone_map", Value(1.0)}, {"exposure", Value(3.0)}, {"white", Value(0.0)}});
    const Values to_white = with(stages_off(), {{"tone_map", Value(3.0)}, {"white", Value(1.25)}});
    CHECK(std::abs(light_at(drawn_look("crt", field, to_white), 1, 1) - 1.0) < 1e-4);
    CHECK(std::abs(
              light_at(drawn_look("crt", field, with(to_white, {{"tone_map", Value(0.0)}})), 1, 1) -
              1.0) < 1e-4);
    // 3.75 / 4.75; the white point applies to the extended form.
    CHECK(std::abs(light_at(drawn_look("crt", field, reinhard), 1, 1) - 0.7895) < 1e-3);
}

TEST_CASE("a moving pattern is drawn for the end time of each frame") {
    auto roots = find_roots(std::filesystem::path(AFTERGLOW_SOURCE_DIR));
    REQUIRE(roots.has_value());
    const RenderRequest request{
        .look = "crt", .values = {{"crt", "false"}}, .source = "pattern:harbour,size=64x48"};
    auto prepared = prepare(request, Library(std::move(*roots)));
    REQUIRE(prepared.has_value());
    auto offline = Offline::create(std::move(*prepared), {64, 48}, 0.5);
    REQUIRE(offline.has_value());
    for (const double seconds : {2.0, 4.0}) {
        offline->advance();
        CHECK(differing_codes(offline->picture(), *make_pattern("harbour,size=64x48", seconds)) ==
              0);
    }
}
