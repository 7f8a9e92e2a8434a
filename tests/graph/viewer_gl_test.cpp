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
constexpr double step = 1.0 / 255.0;
}  // namespace

TEST_CASE_FIXTURE(Viewing,
                  "linear light is encoded for the display, encoded texels are shown as they are") {
    CHECK(shown(one({0.214041f, 1, 0, 0}), {})[0] == doctest::Approx(0.5).epsilon(step));
    CHECK(shown(one({0.2f, 1, 0, 0}), plain)[0] == doctest::Approx(0.2).epsilon(step));
    CHECK(shown(one({0.2f, 1, 0, 0}), plain)[3] == 1.0f);
}

TEST_CASE_FIXTURE(Viewing, "a stop of exposure doubles the light, also of encoded texels") {
    CHECK(shown(one({0.107021f, 0, 0, 1}), {.exposure_stops = 1})[0] ==
          doctest::Approx(0.5).epsilon(step));
    const Rgba encoded =
        shown(one({0.5f, 0, 0, 1}), {.exposure_stops = -1, .encoding = Encoding::display});
    CHECK(encoded[0] == doctest::Approx(0.36).epsilon(0.01));  // sRGB of 0.107
}

TEST_CASE_FIXTURE(Viewing, "one channel is shown in grey, luminance by BT.709") {
    const Picture picture = one({0.1f, 0.4f, 0.8f, 0.6f});
    const auto grey = [&](ChannelChoice channels) {
        const Rgba seen = shown(picture, {.channels = channels, .encoding = Encoding::display});
        CHECK(seen[0] == seen[1]);
        CHECK(seen[1] == seen[2]);
        return static_cast<double>(seen[0]);
    };
    CHECK(grey(ChannelChoice::red) == doctest::Approx(0.1).epsilon(step));
    CHECK(grey(ChannelChoice::green) == doctest::Approx(0.4).epsilon(step));
    CHECK(grey(ChannelChoice::blue) == doctest::Approx(0.8).epsilon(step));
    CHECK(grey(ChannelChoice::alpha) == doctest::Approx(0.6).epsilon(step));
    CHECK(grey(ChannelChoice::luminance) ==
          doctest::Approx(0.2126 * 0.1 + 0.7152 * 0.4 + 0.0722 * 0.8).epsilon(step));
}

TEST_CASE_FIXTURE(Viewing,
                  "a region is magnified in whole texels, and outside of the picture is nothing") {
    ViewOptions options = plain;
    options.left = 3;
    options.bottom = 3;  // the top right texel in the view's bottom left quarter
    options.width = 2;
    options.height = 2;
    CHECK(shown(ramp(), options, {4, 4}, 0, 3)[0] == doctest::Approx(0.75).epsilon(step));
    CHECK(shown(ramp(), options, {4, 4}, 1, 2)[0] == doctest::Approx(0.75).epsilon(step));
    CHECK(shown(ramp(), options, {4, 4}, 2, 3) == Rgba{0, 0, 0, 0});
    CHECK(shown(ramp(), options, {4, 4}, 0, 0) == Rgba{0, 0, 0, 0});
}

TEST_CASE_FIXTURE(Viewing, "a smaller view is the mean of what it covers, upright") {
    const Rgba all = shown(ramp(), plain, {1, 1});
    CHECK(all[0] == doctest::Approx(0.375).epsilon(0.01));
    const Rgba top_right = shown(ramp(), plain, {2, 2}, 1, 0);
    CHECK(top_right[0] == doctest::Approx(0.625).epsilon(0.02));
    CHECK(top_right[1] == doctest::Approx(0.125).epsilon(0.05));
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
