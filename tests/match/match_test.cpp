// Photos of known screens are matched, or refused. `./run soak match` matches more and larger ones.
#include "io/temporary_folder.h"
#include "lab/match/photo_check.h"
#include "match/trial.h"
#include "model/photo/screen_corners.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
double relative_error(const TrialResult& result, const std::string& name) {
    const double truth = result.truth.at(name);
    return std::abs(result.matched.state.values.at(name).number() / truth - 1.0);
}

std::string refusal(const Trial& trial) {
    const TemporaryFolder folder;
    const auto result = run_trial(trial, folder.path());
    return result ? "matched" : result.error().front().message;
}
}  // namespace

TEST_CASE("a photo gives the type of a mask and the numbers of the look") {
    for (const int mask : {1, 2, 3}) {
        CAPTURE(mask);
        const TemporaryFolder folder;
        const auto result = run_trial(
            {.seed = 5, .mask = mask, .corner_error = 0.5, .is_small = true}, folder.path());
        REQUIRE(result);
        CHECK(result->matched.state.values.at("mask_type").number() == mask);
        CHECK(relative_error(*result, "mask_size") < 0.005);
        CHECK(relative_error(*result, "scanline_period") < 0.01);
        CHECK(relative_error(*result, "mask_strength") < 0.2);
        CHECK(relative_error(*result, "scanline_strength") < 0.25);
        CHECK(result->matched.residual < 1.2 * result->residual_of_truth);
        CHECK(result->matched.explained > result->explained_by_truth - 0.01);
        CHECK(result->matched.explained < 1.0);
        for (const FoundNumber& number : result->matched.numbers) {
            CHECK(number.low < number.value);
            CHECK(number.value < number.high);
        }
    }
}

TEST_CASE("a photo that can't be matched is refused with the reason") {
    CHECK(refusal({.seed = 1, .corner_error = 15.0, .is_small = true})
              .starts_with("The corners are "));
    CHECK(refusal({.seed = 1, .is_small = true, .source = "pattern:smpte"})
              .starts_with("The photo does not show this source at these corners"));
    CHECK(refusal({.seed = 1, .is_small = true, .mask_size = 2.0})
              .starts_with("The photo does not show the mask"));
}

TEST_CASE("the straight edges of a screen give its corners") {
    for (const int seed : {1, 2, 3}) {
        CAPTURE(seed);
        const TemporaryFolder folder;
        const Trial trial{.seed = seed, .is_small = true};
        const auto photo = take_photo(trial, folder.path());
        REQUIRE(photo);
        const auto guessed = guess_corners(*photo);
        REQUIRE(guessed);
        for (std::size_t i = 0; i < 4; ++i)
            CHECK(glm::length((*guessed)[i] - true_corners(trial)[i]) < 0.03 * photo->extent.width);
    }
    const Picture grey{
        {400, 300}, 3, Encoding::display, std::vector<float>(std::size_t{400} * 300 * 3, 0.5F)};
    CHECK(!guess_corners(grey));
}

TEST_CASE("a screen's size has the nearest usual shape") {
    const Corners corners{glm::dvec2(10, 20), glm::dvec2(810, 24), glm::dvec2(806, 622),
                          glm::dvec2(14, 618)};
    CHECK(screen_size(corners_of({320, 240})) == Extent{320, 240});
    CHECK(screen_size(corners_of({500, 400})) == Extent{500, 400});
    const Extent size = screen_size(corners);
    CHECK(size.width == doctest::Approx(796).epsilon(0.01));
    CHECK(size.width * 3 == doctest::Approx(size.height * 4).epsilon(0.01));
}

TEST_CASE("a photo is checked before it is matched") {
    Picture photo{{100, 80}, 3, Encoding::display, std::vector<float>(24000, 0.5F)};
    const Corners all = corners_of(photo.extent);
    CHECK(check_photo(photo, all, "photo.png"));
    std::fill_n(photo.pixels.begin(), 2400, 1.0F);
    const auto bright = check_photo(photo, all, "photo.png");
    REQUIRE(!bright);
    CHECK(bright.error().front().message.starts_with("The photo is overexposed: 10 %"));
    Corners crossed = all;
    std::swap(crossed[0], crossed[1]);
    CHECK(!check_photo(photo, crossed, "photo.png"));
    CHECK(!load_photo("/no/such/photo.jpg"));
}
