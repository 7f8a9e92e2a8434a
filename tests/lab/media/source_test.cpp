#include "lab/media/source.h"

#include "io/pictures/picture_file.h"
#include "io/temporary_folder.h"
#include "model/look/color.h"
#include "problems_of.h"
#include "signals/patterns/patterns.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {
Picture level(float value) {
    return {{2, 1}, 3, Encoding::linear, std::vector<float>(6, value)};
}

// Pictures 5, 6, 7 of a sequence. The values of each are its number.
std::string sequence(const TemporaryFolder& folder, const std::string& settings) {
    for (const int number : {5, 6, 7}) {
        const auto file = folder / ("f_" + std::to_string(number) + ".exr");
        REQUIRE(save_picture(level(static_cast<float>(number)), file).has_value());
    }
    return (folder / "f_%d.exr").string() + settings;
}

Source opened(const std::string& text) {
    auto source = Source::open(text);
    REQUIRE_MESSAGE(source.has_value(), problems_of(source));
    return std::move(*source);
}

// The values in frames 1, 2, ... of a clock.
std::vector<float> shown(Source& source, int frames, double fps) {
    std::vector<float> values;
    for (int frame = 1; frame <= frames; ++frame)
        values.push_back(source.wait_for(frame / fps)->pixels.front());
    return values;
}
}  // namespace

TEST_CASE("at equal rates each frame shows the next picture, then loops or holds the last") {
    const TemporaryFolder folder;
    Source looping = opened(sequence(folder, ",rate=24"));
    CHECK(shown(looping, 7, 24) == std::vector<float>{5, 6, 7, 5, 6, 7, 5});
    Source held = opened(sequence(folder, ",rate=24,loop=off"));
    CHECK(shown(held, 5, 24) == std::vector<float>{5, 6, 7, 7, 7});
    CHECK(held.wait_for(2 / 24.0)->pixels.front() == 6.0f);  // also backwards
    Source slow = opened(sequence(folder, ",rate=30"));
    CHECK(shown(slow, 6, 60) == std::vector<float>{5, 5, 6, 6, 7, 7});
    Source usual = opened(sequence(folder, ""));
    CHECK(usual.rate() == 60.0);
    CHECK(usual.moves());
}

TEST_CASE("a film is read in the encoding of its look") {
    constexpr int count = 20;  // more than the read-ahead
    const TemporaryFolder folder;
    for (int number = 0; number < count; ++number)
        REQUIRE(save_picture(level(0.5f), folder / ("f_" + std::to_string(number) + ".exr")));
    Source source = opened((folder / "f_%d.exr").string() + ",rate=10");
    CHECK(source.wait_for(0.1)->encoding == Encoding::linear);
    source.expect(Encoding::display);
    const SharedPicture later = source.wait_for(count / 10.0);
    CHECK(later->encoding == Encoding::display);
    CHECK(later->pixels.front() == doctest::Approx(srgb_encode(0.5)).epsilon(1e-6));
}

TEST_CASE("a missing picture repeats the previous one and is reported once") {
    const TemporaryFolder folder;
    const std::string name = sequence(folder, ",rate=10");
    std::filesystem::remove(folder / "f_6.exr");
    Source source = opened(name);
    CHECK(shown(source, 6, 10) == std::vector<float>{5, 5, 7, 5, 5, 7});
    const Diagnostics problems = source.take_problems();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].message ==
          "picture 6 is missing. The sequence has 2 pictures, numbered 5 to 7.");
    CHECK(source.take_problems().empty());
}

TEST_CASE("NaN and infinity are replaced and reported, and light above 1 stays") {
    const TemporaryFolder folder;
    Picture picture = level(3.5f);
    picture.pixels[0] = std::numeric_limits<float>::quiet_NaN();
    picture.pixels[4] = -std::numeric_limits<float>::infinity();
    const auto file = folder / "odd.exr";
    REQUIRE(save_picture(picture, file).has_value());
    Source source = opened(file.string() + ",fit=whole");
    CHECK(source.picture_at(0.0)->pixels ==
          std::vector<float>{0.0f, 3.5f, 3.5f, 3.5f, -65504.0f, 3.5f});
    const Diagnostics problems = source.take_problems();
    REQUIRE(problems.size() == 1);
    CHECK(to_string(problems[0]) == file.string() +
                                        ": warning: contains 2 NaN or Inf values, read as 0 or "
                                        "±65504");
    CHECK_FALSE(source.moves());
}

TEST_CASE("the smallest and a very wide picture are accepted as sources") {
    const TemporaryFolder folder;
    for (const Extent extent : {Extent{1, 1}, Extent{16384, 1}}) {
        const Picture picture{extent, 3, Encoding::linear,
                              std::vector<float>(static_cast<std::size_t>(extent.width) * 3, 0.5f)};
        REQUIRE(save_picture(picture, folder / "edge.exr").has_value());
        Source source = opened((folder / "edge.exr").string());
        CHECK(source.extent() == extent);
    }
}

TEST_CASE("an invalid source is reported") {
    const TemporaryFolder folder;
    const auto refused = [](const std::string& text) {
        const auto source = Source::open(text);
        REQUIRE_FALSE(source.has_value());
        return to_string(source.error().front());
    };
    CHECK(refused((folder / "f_%04d.png").string())
              .ends_with("no numbered pictures match this name"));
    CHECK(refused("pattern:smpte,fit=tall").find("unknown fit 'tall'") != std::string::npos);
    const auto video = folder.write("v.mp4", "no video");
    CHECK(refused(video.string()).starts_with(video.string() + ": error: can't read the video"));
}

TEST_CASE("a moving pattern is drawn for each requested time") {
    Source source = opened("pattern:harbour,size=64x48,fit=integer");
    CHECK(source.moves());
    CHECK_FALSE(source.is_film());
    for (const double seconds : {0.0, 4.0, 2.0}) {
        const auto expected = make_pattern("harbour,size=64x48", seconds);
        REQUIRE(expected.has_value());
        CHECK(source.wait_for(seconds)->pixels == expected->pixels);
        CHECK(source.picture_at(seconds)->pixels == expected->pixels);
    }
    CHECK(source.picture_at(1.0)->pixels != source.picture_at(3.0)->pixels);
    const SharedPicture before = source.picture_at(1.001);  // in the same sixth of a second
    CHECK(source.picture_at(1.002) == before);
    CHECK_FALSE(source.is_late());
    CHECK_FALSE(opened("pattern:white").moves());
}
