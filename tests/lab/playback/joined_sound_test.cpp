#include "lab/playback/joined_sound.h"

#include <doctest/doctest.h>

TEST_CASE("sounds are joined sample by sample, without a gap") {
    Sound sound{1000, 2, {0.1f, 0.2f, 0.3f, 0.4f}};
    REQUIRE(append_sound(sound, {1000, 2, {0.5f, 0.6f}}).has_value());
    CHECK(sound.samples == std::vector{0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f});
    CHECK(sound.seconds() == doctest::Approx(0.003));
}

TEST_CASE("mono plays on both sides of a joined sound") {
    Sound stereo{1000, 2, {0.1f, 0.2f}};
    REQUIRE(append_sound(stereo, {1000, 1, {0.5f}}).has_value());
    CHECK(stereo.samples == std::vector{0.1f, 0.2f, 0.5f, 0.5f});
    Sound mono{1000, 1, {0.5f}};
    REQUIRE(append_sound(mono, {1000, 2, {0.1f, 0.2f}}).has_value());
    CHECK(mono.channels == 2);
    CHECK(mono.samples == std::vector{0.5f, 0.5f, 0.1f, 0.2f});
}

TEST_CASE("sounds with other rates or channels are refused") {
    Sound sound{1000, 2, {0.1f, 0.2f}};
    const auto rate = append_sound(sound, {48000, 2, {0.1f, 0.2f}});
    REQUIRE_FALSE(rate.has_value());
    CHECK(rate.error().front().message ==
          "the sample rate is 48000 Hz, but 1000 Hz in the first sound. Convert one of them.");
    CHECK_FALSE(append_sound(sound, {1000, 6, std::vector<float>(6)}).has_value());
    CHECK(sound.samples.size() == 2);
}
