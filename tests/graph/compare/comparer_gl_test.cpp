#include "about.h"
#include "gpu/objects/texels.h"
#include "graph/compare/comparer.h"
#include "graph/compare/pair_meter.h"
#include "graph/compare/signed_difference.h"
#include "graph/looks.h"
#include "model/look/color.h"

#include <limits>
#include <random>

namespace {
gpu::Texture texture_of(const Picture& picture, Format format = Format::rgba32f) {
    auto texture = gpu::texture_of(picture, format, picture.encoding);
    REQUIRE(texture.has_value());
    return std::move(*texture);
}

gpu::Canvas canvas_of(Extent extent) {
    auto canvas = gpu::Canvas::make(extent, Format::rgba32f);
    REQUIRE(canvas.has_value());
    return std::move(*canvas);
}

struct Comparing : Headless {
    Result<Comparer> comparer = Comparer::make();
    Result<PairMeter> meter = PairMeter::make();

    Comparing() {
        REQUIRE(comparer.has_value());
        REQUIRE(meter.has_value());
    }
    PairMeasured answer() {
        for (;;)
            if (auto measured = meter->take())
                return *measured;
    }
    Distances distances(const Picture& ours, const Picture& other, double tolerance) {
        const gpu::Texture a = texture_of(ours);
        const gpu::Texture b = texture_of(other);
        meter->start_distances({a, b}, tolerance);
        return answer().distances.value();
    }
    PassChange change(const Picture& ours, const Picture& other, bool as_shown) {
        const gpu::Texture a = texture_of(ours);
        const gpu::Texture b = texture_of(other);
        meter->start_change({a, b, ours.encoding}, as_shown);
        return answer().change.value();
    }
    Luminances luminances(const Picture& ours, const Picture& other) {
        const gpu::Texture a = texture_of(ours);
        const gpu::Texture b = texture_of(other);
        meter->start_luminances({a, b, ours.encoding});
        return answer().luminances.value();
    }
};

Picture noise(Extent extent, unsigned seed) {
    Picture picture{extent, 3, Encoding::display, {}};
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> numbers(-0.1f, 1.2f);
    for (int i = 0; i < extent.width * extent.height * 3; ++i)
        picture.pixels.push_back(numbers(random));
    return picture;
}

Picture even(Extent extent, std::array<float, 3> rgb, Encoding encoding = Encoding::display) {
    Picture picture{extent, 3, encoding, {}};
    for (int i = 0; i < extent.width * extent.height; ++i)
        picture.pixels.insert(picture.pixels.end(), rgb.begin(), rgb.end());
    return picture;
}
}  // namespace

TEST_CASE_FIXTURE(Comparing, "the difference of two pictures is the same on GPU and CPU") {
    const Picture a = noise({97, 71}, 1);  // not a multiple of the block size
    Picture b = noise({97, 71}, 2);
    b.pixels[b.index(96, 70)] = a.pixels[a.index(96, 70)] + 3.0f;
    const auto expected = difference_between(a, b, 0.5);
    REQUIRE(expected.has_value());
    const Distances measured = distances(a, b, 0.5);
    CHECK(measured.mean == about(expected->mean, 1e-5));
    CHECK(measured.rms == about(expected->rms, 1e-5));
    CHECK(measured.largest == about(expected->largest, 1e-6));
    CHECK(measured.psnr_db == about(expected->psnr_db, 1e-5));
    CHECK(measured.share_beyond == about(expected->share_beyond, 1e-9));
    CHECK(expected->share_beyond > 0.2);
}

TEST_CASE_FIXTURE(
    Comparing,
    "equal pictures have infinite PSNR, and a NaN against a number has infinite difference") {
    Picture a = noise({40, 20}, 3);
    a.pixels[a.index(5, 5)] = std::numeric_limits<float>::quiet_NaN();
    Picture b = a;
    CHECK(distances(a, b, 0.0).largest == 0.0);
    CHECK(std::isinf(distances(a, b, 0.0).psnr_db));
    CHECK(distances(a, b, 0.0).psnr_db > 0.0);
    b.pixels[b.index(5, 5)] = 0.5f;
    CHECK(std::isinf(distances(a, b, 0.0).mean));
    CHECK(distances(a, b, 0.0).share_beyond == about(1.0 / 800.0, 1e-9));
}

TEST_CASE_FIXTURE(Comparing, "each difference measure matches its definition at every pixel") {
    const Picture a = noise({33, 5}, 4);
    const Picture b = noise({33, 5}, 5);
    const gpu::Texture ours = texture_of(a);
    const gpu::Texture other = texture_of(b);
    const gpu::Canvas canvas = canvas_of(a.extent);
    for (const auto measure :
         {DifferenceMeasure::absolute, DifferenceMeasure::relative, DifferenceMeasure::squared}) {
        comparer->draw_difference({ours, other}, measure, canvas);
        const Picture measured = gpu::read_picture(canvas.texture());
        double worst = 0.0;
        constexpr std::size_t pixels = std::size_t{33} * 5;
        for (std::size_t i = 0; i < pixels; ++i)
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const std::size_t at = 3 * i + channel;
                const double expected = difference_of(static_cast<double>(a.pixels[at]),
                                                      static_cast<double>(b.pixels[at]), measure);
                const auto is = static_cast<double>(measured.pixels[4 * i + channel]);
                worst = std::max(worst, std::abs(is - expected) / std::max(expected, 1e-3));
            }
        CHECK(worst < 1e-4);
    }
}

TEST_CASE_FIXTURE(Comparing, "a single channel is compared as grey") {
    const gpu::Texture ours =
        texture_of({{2, 1}, 1, Encoding::display, {0.25f, 0.5f}}, Format::r32f);
    const gpu::Texture other = texture_of(even({2, 1}, {0.5f, 0.5f, 0.5f}));
    meter->start_distances({ours, other}, 0.1);
    const Distances measured = answer().distances.value();
    CHECK(measured.mean == 0.125);
    CHECK(measured.share_beyond == 0.5);
}

TEST_CASE_FIXTURE(Comparing,
                  "mean luminance is computed in linear light, clamped to the display range") {
    const auto shown = [](double light) { return static_cast<float>(srgb_encode(light)); };
    Picture half = even({50, 40}, {shown(0.5), shown(0.5), shown(0.5)});
    for (std::size_t i = 0; i < half.pixels.size() / 2; ++i)
        half.pixels[i] = 0.0f;  // mean light 0.25
    CHECK(luminances(half, even({50, 40}, {0.0f, 1.0f, 0.0f})).ours == about(0.25, 1e-4));
    CHECK(luminances(half, even({50, 40}, {0.0f, 1.0f, 0.0f})).other == about(0.7152, 1e-5));
    CHECK(luminances(half, even({50, 40}, {9.0f, -1.0f, 9.0f})).other == about(0.2848, 1e-5));
    const Luminances linear = luminances(even({8, 8}, {0.5f, 0.5f, 0.5f}, Encoding::linear),
                                         even({8, 8}, {1.0f, 0.0f, 0.0f}, Encoding::linear));
    CHECK(linear.ours == about(0.5, 1e-6));
    CHECK(linear.other == about(0.2126, 1e-6));
}

TEST_CASE_FIXTURE(Comparing,
                  "a picture scaled to equal brightness has the same measured luminance") {
    const auto shown = [](double light) { return static_cast<float>(srgb_encode(light)); };
    const Picture ours = even({64, 8}, {shown(0.4), shown(0.4), shown(0.4)});
    const Picture other = even({64, 8}, {0.0f, shown(0.1), 0.0f});  // 0.07152
    const Luminances apart = luminances(ours, other);
    const auto stops = matching_stops(apart.ours, apart.other);
    REQUIRE(stops.has_value());
    CHECK(*stops == about(2.4836, 1e-4));  // log2(0.4 / 0.07152)
    const gpu::Texture a = texture_of(ours);
    const gpu::Texture b = texture_of(other);
    const gpu::Canvas matched = canvas_of(other.extent);
    comparer->draw_brighter(b, Encoding::display, *stops, matched);
    meter->start_luminances({a, matched.texture()});
    const Luminances together = answer().luminances.value();
    CHECK(together.other == about(together.ours, 1e-4));
    CHECK(gpu::read_pixel(matched.texture(), 3, 3)[1] ==
          about(static_cast<double>(shown(0.4 / 0.7152)), 1e-4));
}

TEST_CASE_FIXTURE(Comparing, "a picture of another size is resampled in linear light") {
    Picture board{{4, 4}, 3, Encoding::display, {}};
    for (int i = 0; i < 16; ++i)
        for (int channel = 0; channel < 3; ++channel)
            board.pixels.push_back(static_cast<float>((i + i / 4) % 2));
    const gpu::Texture from = texture_of(board);
    const gpu::Canvas wide = canvas_of({6, 2});
    comparer->draw_fitted(from, Encoding::display, wide, Encoding::display);
    for (const int x : {2, 3})
        CHECK(gpu::read_pixel(wide.texture(), x, 1)[0] == about(srgb_encode(0.5), 1e-5));
    for (const int x : {0, 1, 4, 5})
        CHECK(gpu::read_pixel(wide.texture(), x, 0)[0] == 0.0f);

    const gpu::Texture two = texture_of({{2, 1}, 1, Encoding::linear, {0.0f, 1.0f}});
    const gpu::Canvas larger = canvas_of({8, 4});
    comparer->draw_fitted(two, Encoding::linear, larger, Encoding::linear);
    // A pixel is a quarter of a texel: the fourth has its centre at 0.875, 0.375 beyond the first.
    CHECK(gpu::read_pixel(larger.texture(), 0, 0)[0] == 0.0f);
    CHECK(gpu::read_pixel(larger.texture(), 3, 2)[0] == about(0.375, 1e-6));
    CHECK(gpu::read_pixel(larger.texture(), 4, 2)[0] == about(0.625, 1e-6));
    CHECK(gpu::read_pixel(larger.texture(), 7, 3)[0] == 1.0f);
}

TEST_CASE_FIXTURE(Comparing, "pictures of different sizes and integer targets are not comparable") {
    const gpu::Texture a = texture_of(even({4, 4}, {0, 0, 0}));
    const gpu::Texture b = texture_of(even({4, 5}, {0, 0, 0}));
    auto whole = gpu::Texture::make({4, 4}, Format::r32ui);
    REQUIRE(whole.has_value());
    CHECK(are_comparable(a, a));
    CHECK_FALSE(are_comparable(a, b));
    CHECK_FALSE(are_comparable(a, *whole));
}

TEST_CASE_FIXTURE(Comparing, "the change of a pass is the mean difference and the mean level") {
    const Picture a = even({40, 30}, {0.5f, 2.0f, -0.25f});
    Picture b = a;
    b.pixels[b.index(39, 29) + 1] = 8.0f;  // one number of 3600
    const PassChange measured = change(a, b, false);
    CHECK(measured.mean == about(6.0 / 3600.0, 1e-6));
    CHECK(measured.largest == 6.0);
    CHECK(measured.level == about(2.75 / 3.0, 1e-6));
    // A display clamps values above white and below black.
    const PassChange shown = change(a, b, true);
    CHECK_FALSE(shown.has_changed());
    CHECK(shown.level == about(0.5, 1e-6));
    const Picture light = even({40, 30}, {0.5f, 0.5f, 0.5f}, Encoding::linear);
    const Picture more = even({40, 30}, {0.75f, 0.5f, 0.5f}, Encoding::linear);
    CHECK(change(light, more, true).largest == about(srgb_encode(0.75) - srgb_encode(0.5), 1e-5));
}

TEST_CASE_FIXTURE(Comparing, "a signed difference is centred on middle grey") {
    auto drawing = SignedDifference::make();
    REQUIRE(drawing.has_value());
    const gpu::Texture a = texture_of(even({8, 8}, {0.5f, 0.5f, 2.0f}));
    const gpu::Texture b = texture_of(even({8, 8}, {0.5625f, 0.375f, 4.0f}));
    const gpu::Canvas canvas = canvas_of({8, 8});
    drawing->draw({a, b}, 2.0, canvas);
    const auto measured = gpu::read_pixel(canvas.texture(), 4, 4);
    CHECK(measured[0] == 0.625f);
    CHECK(measured[1] == 0.25f);
    CHECK(measured[2] == 0.5f);  // both are white
    CHECK(measured[3] == 1.0f);
}

TEST_CASE("a small difference is amplified by a power of two") {
    CHECK(gain_for(0.5) == 1.0);
    CHECK(gain_for(1.0) == 1.0);
    CHECK(gain_for(0.01) == 32.0);
    CHECK(gain_for(0.125) == 4.0);
    CHECK(gain_for(1e-9) == 256.0);
    CHECK(gain_for(0.0) == 1.0);
}
