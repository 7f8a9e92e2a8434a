#include "about.h"
#include "gpu/texels.h"
#include "graph/looks.h"
#include "graph/viewer.h"

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

// 4 x 4: each texel's red is its column / 4, its green its row from the top / 4.
Picture ramp() {
    Picture picture{{4, 4}, 4, Encoding::linear, {}};
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            picture.pixels.insert(picture.pixels.end(),
                                  {static_cast<float>(x) / 4, static_cast<float>(y) / 4, 0, 1});
    return picture;
}

constexpr ViewOptions plain{.encoding = Encoding::display};

// A view's texels have 8 bits.
doctest::Approx shade(double expected) {
    return about(expected, 0.55 / 255.0 / expected);
}
}  // namespace

TEST_CASE_FIXTURE(Viewing,
                  "linear light is encoded for the display, encoded texels are shown as they are") {
    CHECK(shown(one({0.214041f, 1, 0, 0}), {})[0] == shade(0.5));
    CHECK(shown(one({0.2f, 1, 0, 0}), plain)[0] == shade(0.2));
    CHECK(shown(one({0.2f, 1, 0, 0}), plain)[3] == 1.0f);
}

TEST_CASE_FIXTURE(Viewing, "a stop of exposure doubles the light, also of encoded texels") {
    CHECK(shown(one({0.107021f, 0, 0, 1}), {.exposure_stops = 1})[0] == shade(0.5));
    const Rgba encoded =
        shown(one({0.5f, 0, 0, 1}), {.exposure_stops = -1, .encoding = Encoding::display});
    CHECK(encoded[0] == shade(0.36078));  // sRGB of 0.10702
}

TEST_CASE_FIXTURE(Viewing, "one channel is shown in grey, luminance by BT.709") {
    const Picture picture = one({0.1f, 0.4f, 0.8f, 0.6f});
    const auto grey = [&](ChannelChoice channels) {
        const Rgba seen = shown(picture, {.channels = channels, .encoding = Encoding::display});
        CHECK(seen[0] == seen[1]);
        CHECK(seen[1] == seen[2]);
        return static_cast<double>(seen[0]);
    };
    CHECK(grey(ChannelChoice::red) == shade(0.1));
    CHECK(grey(ChannelChoice::green) == shade(0.4));
    CHECK(grey(ChannelChoice::blue) == shade(0.8));
    CHECK(grey(ChannelChoice::alpha) == shade(0.6));
    CHECK(grey(ChannelChoice::luminance) == shade(0.2126 * 0.1 + 0.7152 * 0.4 + 0.0722 * 0.8));
}

TEST_CASE_FIXTURE(Viewing,
                  "a region is magnified in whole texels, and outside of the picture is nothing") {
    ViewOptions options = plain;
    options.left = 3;
    options.bottom = 3;  // the top right texel in the view's bottom left quarter
    options.width = 2;
    options.height = 2;
    CHECK(shown(ramp(), options, {4, 4}, 0, 3)[0] == shade(0.75));
    CHECK(shown(ramp(), options, {4, 4}, 1, 2)[0] == shade(0.75));
    CHECK(shown(ramp(), options, {4, 4}, 2, 3) == Rgba{0, 0, 0, 0});
    CHECK(shown(ramp(), options, {4, 4}, 0, 0) == Rgba{0, 0, 0, 0});
}

TEST_CASE_FIXTURE(Viewing, "a smaller view is the mean of what it covers, upright") {
    const Rgba all = shown(ramp(), plain, {1, 1});
    CHECK(all[0] == shade(0.375));
    const Rgba top_right = shown(ramp(), plain, {2, 2}, 1, 0);
    CHECK(top_right[0] == shade(0.625));
    CHECK(top_right[1] == shade(0.125));
}

TEST_CASE_FIXTURE(Viewing,
                  "what is not a number shows as magenta, an integer target as its number") {
    CHECK(shown(one({std::numeric_limits<float>::quiet_NaN(), 0, 0, 1}), {}) == Rgba{1, 0, 1, 1});
    auto whole = gpu::Canvas::make({1, 1}, Format::r32ui);
    auto to = gpu::Canvas::make({1, 1}, Format::rgba8);
    REQUIRE((whole && to && viewer));
    whole->clear({1, 0, 0, 0});
    viewer->draw(whole->texture(), *to, plain);
    CHECK(gpu::read_pixel(to->texture(), 0, 0) == Rgba{1, 1, 1, 1});
}
