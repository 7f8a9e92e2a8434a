#include "about.h"
#include "gpu/objects/texels.h"
#include "graph/inspect/viewer.h"
#include "graph/looks.h"

#include <cmath>
#include <limits>

namespace {
struct Viewing : Headless {
    Result<Viewer> viewer = Viewer::make();

    Rgba shown(const Picture& picture, const ViewOptions& options, Extent view = {4, 4}, int x = 0,
               int y = 0, Format format = Format::rgba32f) {
        REQUIRE(viewer.has_value());
        auto from = gpu::Texture::make(picture.extent, format);
        auto to = gpu::Canvas::make(view, Format::rgba8);
        REQUIRE((from && to));
        std::vector<float> texels;
        gpu::fill_texels(picture, picture.encoding, texels);
        from->upload(texels);
        viewer->draw(*from, *to, options);
        return gpu::read_pixel(to->texture(), x, y);
    }
};

Picture one(Rgba rgba) {
    return {{1, 1}, 4, Encoding::linear, {rgba[0], rgba[1], rgba[2], rgba[3]}};
}

Picture grey(double number) {
    return {{1, 1}, 1, Encoding::linear, {static_cast<float>(number)}};
}

// 4 x 4: red is the column / 4, green the row from the top / 4.
Picture ramp() {
    Picture picture{{4, 4}, 4, Encoding::linear, {}};
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            picture.pixels.insert(picture.pixels.end(),
                                  {static_cast<float>(x) / 4, static_cast<float>(y) / 4, 0, 1});
    return picture;
}

constexpr ViewOptions plain{.encoding = Encoding::display};

// Texels of a view have 8 bits.
doctest::Approx shade(double expected) {
    return about(expected, 0.55 / 255.0 / expected);
}
}  // namespace

TEST_CASE_FIXTURE(
    Viewing, "linear light is encoded for the display, and encoded texels are shown unchanged") {
    CHECK(shown(one({0.214041f, 1, 0, 0}), {})[0] == shade(0.5));
    CHECK(shown(one({0.2f, 1, 0, 0}), plain)[0] == shade(0.2));
    CHECK(shown(one({0.2f, 1, 0, 0}), plain)[3] == 1.0f);
}

TEST_CASE_FIXTURE(Viewing, "one stop of exposure doubles the light, also of encoded texels") {
    CHECK(shown(one({0.107021f, 0, 0, 1}), {.exposure_stops = 1})[0] == shade(0.5));
    const Rgba encoded =
        shown(one({0.5f, 0, 0, 1}), {.exposure_stops = -1, .encoding = Encoding::display});
    CHECK(encoded[0] == shade(0.36078));  // sRGB of 0.10702
}

TEST_CASE_FIXTURE(Viewing, "one channel is shown as grey, and luminance follows BT.709") {
    const Picture picture = one({0.1f, 0.4f, 0.8f, 0.6f});
    const auto grey = [&](Channels channels) {
        const Rgba displayed =
            shown(picture, {.channels = channels, .encoding = Encoding::display});
        CHECK(displayed[0] == displayed[1]);
        CHECK(displayed[1] == displayed[2]);
        return static_cast<double>(displayed[0]);
    };
    CHECK(grey(Channels::red) == shade(0.1));
    CHECK(grey(Channels::green) == shade(0.4));
    CHECK(grey(Channels::blue) == shade(0.8));
    CHECK(grey(Channels::alpha) == shade(0.6));
    CHECK(grey(Channels::luminance) == shade(0.2126 * 0.1 + 0.7152 * 0.4 + 0.0722 * 0.8));
}

TEST_CASE_FIXTURE(Viewing, "a single-channel target is shown as grey") {
    const Rgba displayed = shown(grey(0.4), plain, {4, 4}, 0, 0, Format::r32f);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(displayed[i] == shade(0.4));
}

TEST_CASE_FIXTURE(Viewing,
                  "a region is magnified by whole texels, and outside the picture is transparent") {
    ViewOptions options = plain;
    options.left = 3;
    options.bottom = 3;  // the top right texel, in the view's bottom left quarter
    options.width = 2;
    options.height = 2;
    CHECK(shown(ramp(), options, {4, 4}, 0, 3)[0] == shade(0.75));
    CHECK(shown(ramp(), options, {4, 4}, 1, 2)[0] == shade(0.75));
    CHECK(shown(ramp(), options, {4, 4}, 2, 3) == Rgba{0, 0, 0, 0});
    CHECK(shown(ramp(), options, {4, 4}, 0, 0) == Rgba{0, 0, 0, 0});
}

TEST_CASE_FIXTURE(Viewing, "a smaller view is the mean of the covered texels, upright") {
    const Rgba all = shown(ramp(), plain, {1, 1});
    CHECK(all[0] == shade(0.375));
    const Rgba top_right = shown(ramp(), plain, {2, 2}, 1, 0);
    CHECK(top_right[0] == shade(0.625));
    CHECK(top_right[1] == shade(0.125));
}

TEST_CASE_FIXTURE(Viewing, "a NaN is shown as magenta, and an integer target by its value") {
    CHECK(shown(one({std::numeric_limits<float>::quiet_NaN(), 0, 0, 1}), {}) == Rgba{1, 0, 1, 1});
    auto whole = gpu::Canvas::make({1, 1}, Format::r32ui);
    auto to = gpu::Canvas::make({1, 1}, Format::rgba8);
    REQUIRE((whole && to && viewer));
    whole->clear({1, 0, 0, 0});
    viewer->draw(whole->texture(), *to, plain);
    CHECK(gpu::read_pixel(to->texture(), 0, 0) == Rgba{1, 1, 1, 1});
}

TEST_CASE_FIXTURE(Viewing,
                  "the range between black and white level is stretched over the display range") {
    ViewOptions options = plain;
    options.levels = {2, 6};
    CHECK(shown(one({3, 2, 7, 1}), options) == Rgba{shown(one({0.25f, 0, 1, 1}), plain)});
    options.encoding = Encoding::linear;
    CHECK(shown(one({2.856164f, 0, 0, 1}), options)[0] == shade(0.5));  // 2 + 4 * 0.214041
    options.exposure_stops = 1;  // relative to the black level
    CHECK(shown(one({2.428082f, 0, 0, 1}), options)[0] == shade(0.5));
    options.levels = {-1, 1};
    options.exposure_stops = 0;
    CHECK(shown(one({-0.571918f, 0, 0, 1}), options)[0] == shade(0.5));
}

namespace {
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

constexpr Rgba pure_red{1, 0, 0, 1};
constexpr Rgba green{0, 1, 0, 1};
constexpr Rgba blue{0, 0, 1, 1};
}  // namespace

TEST_CASE_FIXTURE(Viewing, "invalid values are marked in pure colours, and valid ones are grey") {
    ViewOptions options = plain;
    options.marks_flaws = true;
    CHECK(shown(one({no_number, -1, infinity, 1}), options) == pure_red);
    CHECK(shown(one({0, infinity, -1, 1}), options) == green);
    CHECK(shown(one({0, -infinity, 0, 1}), options) == green);
    CHECK(shown(one({0.5f, 0.5f, -0.001f, 1}), options) == blue);
    CHECK(shown(one({0, 0, 0, no_number}), options) == Rgba{0, 0, 0, 1});  // alpha is not shown
    const Rgba grey = shown(one({0, 1, 0, 1}), options);
    CHECK(grey[1] == shade(0.7152));
    CHECK((grey[0] == grey[1] && grey[1] == grey[2]));
    options.channels = Channels::alpha;
    CHECK(shown(one({0, 0, 0, no_number}), options) == pure_red);
}

TEST_CASE_FIXTURE(Viewing, "one invalid texel is visible in a view smaller than the target") {
    Picture picture{{60, 60}, 1, Encoding::linear, std::vector<float>(3600, 0.5f)};
    picture.pixels[picture.index(31, 17)] = no_number;
    picture.pixels[picture.index(5, 50)] = -1.0f;
    ViewOptions options{.marks_flaws = true};
    CHECK(shown(picture, options, {6, 6}, 3, 1) == pure_red);
    CHECK(shown(picture, options, {6, 6}, 0, 5) == blue);
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 6; ++x)
            if ((x != 3 || y != 1) && (x != 0 || y != 5))
                CHECK(shown(picture, options, {6, 6}, x, y)[0] == shade(0.735357));
}

TEST_CASE_FIXTURE(Viewing, "clipped texels are marked at the limits of the view") {
    ViewOptions options = plain;
    options.marks_clipping = true;
    const Rgba white = shown(one({0.2f, 1.0f, 0.2f, 1}), options);
    CHECK(white[0] == 1.0f);
    CHECK(white[1] == shade(0.8));
    CHECK(white[2] == 0.0f);
    const Rgba black = shown(one({0, -1, 0, 1}), options);
    CHECK(black[0] == 0.0f);
    CHECK(black[1] == shade(0.25));
    CHECK(black[2] == shade(0.3));
    const Rgba between = shown(one({0.99f, 0, 0, 1}), options);
    CHECK(between[0] == shade(0.2126 * 0.99));
    options.levels = {0.2, 0.6};
    CHECK(shown(one({0.6f, 0, 0, 1}), options) == white);
    CHECK(shown(one({0.2f, 0.2f, 0.1f, 1}), options) == black);
    options = {.exposure_stops = 3, .marks_clipping = true};
    CHECK(shown(one({0.13f, 0, 0, 1}), options) == white);
    CHECK(shown(one({0.12f, 0, 0, 1}), options) != white);
}

TEST_CASE_FIXTURE(Viewing, "false colours increase in brightness with the value") {
    ViewOptions options{.levels = {0, 2}, .is_false_color = true};
    // Property of the scheme: its NTSC luma equals the position on the ramp.
    for (const double place : {0.0, 0.125, 0.25, 0.5, 0.625, 0.75, 1.0}) {
        const Rgba color = shown(grey(2 * place), options);
        const double bright = 0.30 * color[0] + 0.59 * color[1] + 0.11 * color[2];
        CHECK(std::abs(bright - place) <= 1.0 / 255.0);
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(std::abs(color[i] - false_color(place)[i]) <= 0.55 / 255.0);
    }
    // At the middle the hue angle is 1/6 - 3/4 of a circle: cos -0.866025, sin 0.5.
    CHECK(false_color(0.5)[0] == about(0.5 + 0.125 * (0.14861 * 0.866025 + 1.78277 * 0.5), 1e-5));
    CHECK(false_color(0.5)[1] == about(0.5 + 0.125 * (0.29227 * 0.866025 - 0.90649 * 0.5), 1e-5));
    CHECK(false_color(0.5)[2] == about(0.5 - 0.125 * 1.97294 * 0.866025, 1e-5));
    const Rgba of_luminance = shown(one({2, 0, 0, 1}), options);
    CHECK(std::abs(of_luminance[0] - false_color(0.2126)[0]) <= 0.55 / 255.0);
}

TEST_CASE_FIXTURE(Viewing, "a transparent picture is shown over a checkerboard by its alpha") {
    const ViewOptions over{.encoding = Encoding::display, .is_over_checker = true};
    const Rgba one_square = shown(one({1.0f, 0.5f, 0.0f, 0.0f}), over, {32, 32}, 0, 0);
    const Rgba other_square = shown(one({1.0f, 0.5f, 0.0f, 0.0f}), over, {32, 32}, 8, 0);
    for (const Rgba& square : {one_square, other_square}) {
        CHECK(square[0] == square[1]);
        CHECK(square[1] == square[2]);
        CHECK(square[3] == 1.0f);
    }
    CHECK(std::abs(other_square[0] - one_square[0]) > 0.02f);  // two greys with
    CHECK(std::abs(other_square[0] - one_square[0]) < 0.10f);  // a small difference
    CHECK(shown(one({1, 1, 1, 0}), over, {32, 32}, 8, 8)[0] == one_square[0]);
    const Rgba half = shown(one({1.0f, 0.5f, 0.0f, 0.25f}), over, {32, 32}, 0, 0);
    const std::array<double, 3> colors{1.0, 0.5, 0.0};
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(half[i] == shade(0.75 * static_cast<double>(one_square[0]) + 0.25 * colors[i]));
    CHECK(shown(one({1.0f, 0.5f, 0.25f, 1.0f}), over)[1] == shade(0.5));
    CHECK(shown(one({1.0f, 0.5f, 0.25f, 7.0f}), over)[2] == shade(0.25));
}

TEST_CASE_FIXTURE(Viewing, "a single channel and false colours are shown without a checkerboard") {
    ViewOptions over{.encoding = Encoding::display, .is_over_checker = true};
    over.channels = Channels::red;
    CHECK(shown(one({1, 0, 0, 0}), over)[0] == 1.0f);
    over.channels = Channels::color;
    over.is_false_color = true;
    CHECK(shown(one({1, 1, 1, 0}), over)[0] == 1.0f);
}
