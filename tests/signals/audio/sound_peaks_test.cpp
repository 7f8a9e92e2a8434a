#include "signals/audio/sound_peaks.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {
std::shared_ptr<const Sound> noise(std::size_t frames, int channels) {
    auto sound = std::make_shared<Sound>(Sound{1000, channels, {}});
    std::uint32_t state = 1;
    for (std::size_t i = 0; i < frames * static_cast<std::size_t>(channels); ++i) {
        state = state * 1664525u + 1013904223u;
        sound->samples.push_back(static_cast<float>(state >> 8) / 8388608.0f - 1.0f);
    }
    return sound;
}

SoundPeaks peaks_of(std::shared_ptr<const Sound> sound) {
    JobProgress work;
    return SoundPeaks::measure(std::move(sound), work).value();
}

Peak searched(const Sound& sound, std::size_t channel, std::size_t first, std::size_t end) {
    Peak peak{2.0f, -2.0f};
    for (std::size_t i = first; i < std::min(end, sound.frame_count()); ++i) {
        const float sample = sound.samples[i * static_cast<std::size_t>(sound.channels) + channel];
        peak = {std::min(peak.low, sample), std::max(peak.high, sample)};
    }
    return peak;
}
}  // namespace

TEST_CASE("a peak is that of all its samples, wherever the range begins and ends") {
    const auto sound = noise(9001, 2);
    const SoundPeaks peaks = peaks_of(sound);
    for (const auto& [first, end] : std::vector<std::pair<std::size_t, std::size_t>>{{0, 9001},
                                                                                     {0, 1},
                                                                                     {127, 129},
                                                                                     {128, 256},
                                                                                     {1, 2049},
                                                                                     {2048, 4096},
                                                                                     {777, 8888},
                                                                                     {9000, 20000}})
        for (const std::size_t side : {0, 1})
            CHECK(peaks.peak(side, first, end) == searched(*sound, side, first, end));
}

TEST_CASE("an impulse is seen at every zoom") {
    auto sound = std::make_shared<Sound>(Sound{48000, 1, std::vector<float>(4'800'000, 0.0f)});
    sound->samples[3'000'001] = -0.75f;
    const SoundPeaks peaks = peaks_of(sound);
    for (const std::size_t count : {1, 7, 100, 1920}) {
        const auto columns = peaks.columns(0, 0.0, 100.0, count);
        CHECK(std::ranges::count(columns, Peak{-0.75f, 0.0f}) == 1);
    }
    const double at = 3'000'001.0 / 48000.0;
    CHECK(peaks.columns(0, at, at + 1e-6, 1).front().low == -0.75f);
}

TEST_CASE("outside of the sound there is silence") {
    const SoundPeaks peaks = peaks_of(noise(1000, 2));
    for (const Peak& peak : peaks.columns(1, 1.5, 3.0, 10))
        CHECK(peak == Peak{});
    for (const Peak& peak : peaks.columns(1, -3.0, -1.0, 10))
        CHECK(peak == Peak{});
    CHECK(peaks_of(std::make_shared<Sound>(Sound{48000, 2, {}})).peak(0, 0, 10) == Peak{});
}

TEST_CASE("a mono sound is on both sides, and samples that are not finite are silent") {
    auto sound = std::make_shared<Sound>(
        Sound{1000, 1, {0.5f, std::numeric_limits<float>::quiet_NaN(), -0.25f}});
    const SoundPeaks peaks = peaks_of(sound);
    CHECK(peaks.peak(0, 0, 3) == Peak{-0.25f, 0.5f});
    CHECK(peaks.peak(1, 0, 3) == Peak{-0.25f, 0.5f});
    CHECK(peaks.peak(1, 1, 2) == Peak{0.0f, 0.0f});
}

TEST_CASE("measuring can be cancelled") {
    JobProgress work;
    work.is_cancelled = true;
    CHECK_FALSE(SoundPeaks::measure(noise(1000, 2), work).has_value());
}
