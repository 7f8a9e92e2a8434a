#include "about.h"
#include "gpu/objects/texels.h"
#include "graph/inspect/meter.h"
#include "graph/looks.h"

#include <limits>
#include <random>

namespace {
struct Measuring : Headless {
    std::optional<Meter> meter;

    Measuring() {
        auto programs = MeterPrograms::make();
        REQUIRE(programs.has_value());
        meter.emplace(std::make_shared<const MeterPrograms>(std::move(*programs)));
    }

    Measured measured(const gpu::Texture& from, Channels channels,
                      std::optional<double> ceiling = std::nullopt) {
        meter->start(from, channels, ceiling);
        for (;;)
            if (auto answer = meter->take())
                return std::move(*answer);
    }

    Measured measured(const Picture& picture, Channels channels = Channels::color,
                      Format format = Format::rgba32f) {
        auto from = gpu::Texture::make(picture.extent, format);
        REQUIRE(from.has_value());
        std::vector<float> texels;
        gpu::fill_texels(picture, picture.encoding, texels);
        from->upload(texels);
        return measured(*from, channels);
    }
};

Picture noise(Extent extent) {
    Picture picture{extent, 3, Encoding::linear, {}};
    std::mt19937 random(7);
    std::uniform_real_distribution<float> numbers(-1.0f, 3.0f);
    for (int i = 0; i < extent.width * extent.height * 3; ++i)
        picture.pixels.push_back(numbers(random));
    return picture;
}

void check_same(const Statistics& measured, const Statistics& expected) {
    CHECK(measured.finite == expected.finite);
    CHECK(measured.not_a_number == expected.not_a_number);
    CHECK(measured.infinite == expected.infinite);
    CHECK(measured.minimum == expected.minimum);
    CHECK(measured.maximum == expected.maximum);
    CHECK(measured.mean == about(expected.mean, 1e-5));
}
}  // namespace

TEST_CASE_FIXTURE(Measuring, "statistics of a target are the same on GPU and CPU") {
    Picture picture = noise({333, 71});  // not a multiple of the block size
    check_same(measured(picture).statistics, statistics_of(picture));
    picture.pixels[picture.index(332, 70)] = std::numeric_limits<float>::quiet_NaN();
    picture.pixels[picture.index(100, 3) + 1] = std::numeric_limits<float>::infinity();
    picture.pixels[picture.index(101, 3) + 2] = -std::numeric_limits<float>::infinity();
    const Statistics all = measured(picture).statistics;
    CHECK(all.not_a_number == 1);
    CHECK(all.infinite == 2);
    check_same(all, statistics_of(picture));
}

TEST_CASE_FIXTURE(Measuring, "blocks without finite values are ignored") {
    const float no_number = std::numeric_limits<float>::quiet_NaN();
    Picture picture{{40, 40}, 1, Encoding::linear, std::vector<float>(1600, no_number)};
    CHECK(measured(picture).statistics == Statistics{.not_a_number = 1600});
    picture.pixels[picture.index(20, 20)] = -5.0f;
    const Statistics one = measured(picture).statistics;
    CHECK(one.minimum == -5.0);
    CHECK(one.maximum == -5.0);
    CHECK(one.mean == -5.0);
    CHECK(one.not_a_number == 1599);
}

TEST_CASE_FIXTURE(Measuring, "only displayed channels are measured") {
    const Picture picture{{1, 1}, 4, Encoding::linear, {0.25f, -1, 4, 0.5f}};
    CHECK(measured(picture).statistics.minimum == -1.0);
    CHECK(measured(picture).samples.channels == 3);
    const Measured red = measured(picture, Channels::red);
    CHECK(red.statistics == Statistics{0.25, 0.25, 0.25, 1, 0, 0});
    CHECK(red.samples == Picture{{1, 1}, 1, Encoding::linear, {0.25f}});
    CHECK(measured(picture, Channels::alpha).statistics.mean == 0.5);
    CHECK(measured(picture, Channels::luminance).statistics.mean ==
          about(0.2126 * 0.25 - 0.7152 + 0.0722 * 4, 1e-5));
}

TEST_CASE_FIXTURE(Measuring, "single-channel and integer targets are measured as one channel") {
    const Picture grey{{2, 1}, 1, Encoding::linear, {1.0f, 3.0f}};
    const Measured lone = measured(grey, Channels::color, Format::r32f);
    CHECK(lone.statistics == Statistics{1.0, 3.0, 2.0, 2, 0, 0});
    CHECK(lone.samples == grey);
    auto whole = gpu::Canvas::make({4, 4}, Format::r32ui);
    REQUIRE(whole.has_value());
    whole->clear({70000, 0, 0, 0});
    CHECK(measured(whole->texture(), Channels::color).statistics ==
          Statistics{70000, 70000, 70000, 16, 0, 0});
}

TEST_CASE_FIXTURE(Measuring, "samples of a large target have the distribution of its values") {
    // Bands of 0, 1, 2, 3 with a period that divides the distance of the samples.
    Picture bands{{1024, 512}, 1, Encoding::linear, {}};
    for (int i = 0; i < 1024 * 512; ++i)
        bands.pixels.push_back(static_cast<float>(i % 4));
    const Measured all = measured(bands, Channels::red);
    CHECK(all.samples.extent == Extent{256, 256});
    const Histogram histogram = histogram_of(all.samples, -0.5, 3.5, 4);
    for (const std::uint32_t count : histogram.bins[0])
        CHECK(count / 65536.0 == about(0.25, 0.05));  // 7 standard deviations of random samples
    CHECK(all.statistics.mean == 1.5);
}

TEST_CASE_FIXTURE(Measuring, "the meter measures the latest drawn content, repeatedly") {
    auto canvas = gpu::Canvas::make({640, 480}, Format::rgba16f);
    REQUIRE(canvas.has_value());
    for (int i = 1; i <= 20; ++i) {
        const auto number = static_cast<float>(i);
        canvas->clear({number, number, number, 1});
        CHECK(measured(canvas->texture(), Channels::color).statistics.minimum == number);
    }
}

TEST_CASE_FIXTURE(Measuring, "clipped texels are counted once each, at any size") {
    for (const Extent extent : {Extent{333, 71}, Extent{1000, 3}, Extent{17, 600}}) {
        Picture picture = noise(extent);
        picture.pixels[picture.index(2, 1)] = std::numeric_limits<float>::infinity();
        picture.pixels[picture.index(3, 2)] = std::numeric_limits<float>::quiet_NaN();
        std::size_t expected = 0;
        for (std::size_t i = 0; i < picture.pixels.size(); i += 3) {
            const float maximum =
                std::max({picture.pixels[i], picture.pixels[i + 1], picture.pixels[i + 2]});
            expected +=
                std::isfinite(maximum) && std::isfinite(picture.pixels[i]) && maximum >= 2.5f;
        }
        auto from = gpu::Texture::make(extent, Format::rgba32f);
        REQUIRE(from.has_value());
        std::vector<float> texels;
        gpu::fill_texels(picture, picture.encoding, texels);
        from->upload(texels);
        CHECK(expected > 0);
        CHECK(measured(*from, Channels::color, 2.5).clipped == expected);
        CHECK(measured(*from, Channels::color).clipped == 0);
    }
}
