#include "io/sound/sound_player.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <thread>

namespace {
// Left rises, right falls.
std::shared_ptr<const Sound> ramp(int rate, int frames) {
    auto sound = std::make_shared<Sound>(Sound{rate, 2, {}});
    for (int i = 0; i < frames; ++i) {
        sound->samples.push_back(static_cast<float>(i) / 1024.0f);
        sound->samples.push_back(static_cast<float>(-i) / 1024.0f);
    }
    return sound;
}

std::vector<float> mixed(SoundPlayer& player, std::size_t frames) {
    std::vector<float> stereo(2 * frames, 9.0f);
    player.mix(stereo);
    return stereo;
}

double begin_of_next(SoundPlayer& player) {
    std::vector<float> none;
    return player.mix(none).begin_seconds;
}
}  // namespace

TEST_CASE("at speed 1 and the device's rate, samples are played unchanged") {
    const auto sound = ramp(48000, 600);
    SoundPlayer player(48000);
    player.play(sound);
    std::vector<float> heard = mixed(player, 100);
    for (const float sample : mixed(player, 500))
        heard.push_back(sample);
    CHECK(heard == sound->samples);
    CHECK(begin_of_next(player) == doctest::Approx(600.0 / 48000.0));
}

TEST_CASE("other rates and speeds interpolate linearly between samples") {
    SoundPlayer player(48000);
    player.play(ramp(24000, 600));
    player.set_speed(0.5);
    const std::vector<float> heard = mixed(player, 400);  // a quarter of a sample each
    for (std::size_t i = 0; i < 400; ++i)
        REQUIRE(heard[2 * i] == doctest::Approx(static_cast<double>(i) / 4.0 / 1024.0));
    CHECK(begin_of_next(player) == doctest::Approx(400.0 / 48000.0 * 0.5));
}

TEST_CASE("after the end there is silence, and the position stays") {
    SoundPlayer player(1000);
    player.play(ramp(1000, 10));
    const std::vector<float> heard = mixed(player, 20);
    CHECK(heard[18] == 9.0f / 1024.0f);
    for (std::size_t i = 20; i < 40; ++i)
        REQUIRE(heard[i] == 0.0f);
    CHECK(begin_of_next(player) == doctest::Approx(0.01));
    std::vector<float> none;
    CHECK(player.mix(none).seconds_per_second == 0.0);
}

TEST_CASE("a loop continues with its first sample, and its time keeps counting") {
    SoundPlayer player(1000);
    player.play(ramp(1000, 10));
    player.set_loop(true);
    const std::vector<float> heard = mixed(player, 35);
    for (std::size_t i = 0; i < 35; ++i)
        REQUIRE(heard[2 * i] == static_cast<float>(i % 10) / 1024.0f);
    CHECK(begin_of_next(player) == doctest::Approx(0.035));

    player.seek(0.0295);  // halfway from the last sample to the first
    CHECK(mixed(player, 1)[0] == doctest::Approx(4.5 / 1024.0));
}

TEST_CASE("a seek takes effect in the next buffer, which reports it") {
    SoundPlayer player(1000);
    player.play(ramp(1000, 100));
    mixed(player, 10);
    player.seek(0.05);
    std::vector<float> stereo(2);
    const SoundPlayer::Mixed buffer = player.mix(stereo);
    CHECK(buffer.begin_seconds == 0.05);
    CHECK(buffer.jump == player.jump());
    CHECK(stereo[0] == 50.0f / 1024.0f);
    player.seek(-3.0);
    CHECK(mixed(player, 1)[0] == 0.0f);
    player.seek(std::numeric_limits<double>::quiet_NaN());
    CHECK(begin_of_next(player) == 0.0);
    player.seek(1e300);
    CHECK(mixed(player, 1)[0] == 0.0f);
}

TEST_CASE("while paused the output is silent and the position stays") {
    SoundPlayer player(1000);
    player.play(ramp(1000, 100));
    mixed(player, 10);
    player.set_paused(true);
    for (const float sample : mixed(player, 10))
        REQUIRE(sample == 0.0f);
    CHECK(begin_of_next(player) == doctest::Approx(0.01));
    player.set_paused(false);
    CHECK(mixed(player, 1)[0] == 10.0f / 1024.0f);
}

TEST_CASE("a level change is ramped over one buffer, and samples are clamped to -1 .. 1") {
    auto sound = std::make_shared<Sound>(Sound{1000, 1, std::vector<float>(100, 0.8f)});
    SoundPlayer player(1000);
    player.play(sound);
    player.set_level(0.5);
    const std::vector<float> falling = mixed(player, 10);
    CHECK(falling[0] == doctest::Approx(0.8));
    CHECK(falling[10] == doctest::Approx(0.8 * 0.75));
    CHECK(mixed(player, 10)[0] == doctest::Approx(0.4));
    player.set_level(99.0);  // the maximum is 2
    mixed(player, 10);
    CHECK(mixed(player, 10)[5] == 1.0f);
    player.set_level(std::nan(""));
    mixed(player, 10);
    CHECK(mixed(player, 10)[5] == 0.0f);
}

TEST_CASE("mono is played on both channels, and of more channels only the first two") {
    SoundPlayer player(1000);
    player.play(std::make_shared<Sound>(Sound{1000, 1, {0.5f}}));
    CHECK(mixed(player, 1) == std::vector<float>{0.5f, 0.5f});
    player.play(std::make_shared<Sound>(Sound{1000, 3, {0.1f, 0.2f, 0.3f}}));
    CHECK(mixed(player, 1) == std::vector<float>{0.1f, 0.2f});
}

TEST_CASE("a one-sample sound loops at any speed, and no sound or an empty one is silence") {
    SoundPlayer player(48000);
    player.set_loop(true);
    player.set_speed(4.0);
    player.play(std::make_shared<Sound>(Sound{768000, 1, {0.5f}}));
    for (const float sample : mixed(player, 64))
        REQUIRE(sample == doctest::Approx(0.5));
    player.play(std::make_shared<Sound>(Sound{48000, 2, {}}));
    CHECK(mixed(player, 4) == std::vector<float>(8, 0.0f));
    player.play(nullptr);
    CHECK(mixed(player, 4) == std::vector<float>(8, 0.0f));
}

TEST_CASE("a sound is released when another one plays, also while the device is mixing") {
    SoundPlayer player(48000);
    std::atomic<bool> is_done = false;
    std::thread device([&] {
        std::vector<float> stereo(64);
        while (!is_done)
            player.mix(stereo);
    });
    std::weak_ptr<const Sound> first;
    for (int i = 0; i < 2000; ++i) {
        auto sound = ramp(48000, 64);
        if (i == 0)
            first = sound;
        player.play(std::move(sound));
    }
    is_done = true;
    device.join();
    player.play(nullptr);
    CHECK(first.expired());
}

TEST_CASE("a part of a sound repeats from its end to its start") {
    SoundPlayer player(1000);
    player.play(ramp(1000, 10), 0.002, 0.005);
    player.set_loop(true);
    std::array<float, 14> stereo{};
    player.mix(stereo);
    const auto all = ramp(1000, 10);
    for (std::size_t i = 0; i < 7; ++i)
        CHECK(stereo[2 * i] == doctest::Approx(all->samples[(2 + i % 3) * 2]));
}
