#include "signals/audio/sound_texels.h"

#include "signals/beam/beam_sound.h"
#include "signals/beam/beam_stream.h"
#include "signals/signal_making.h"

namespace {
using Holds = SoundTexture::Holds;

constexpr int texel_rate = 48000;
constexpr double texel_bin_hertz = texel_rate / 2048.0;

std::vector<float> levels_of(const SoundTexels& texels, const SoundTexture& texture,
                             double seconds) {
    std::vector<float> levels(2 * static_cast<std::size_t>(texture.columns));
    texels.read(texture, seconds, levels);
    return levels;
}

template <class Left, class Right>
SoundStreamTexels texels_of(const Left& left, const Right& right) {
    return SoundStreamTexels(stream_of(sound_of(texel_rate, 3 * texel_rate, left, right), {}));
}

double silent(int /*sample*/) {
    return 0.0;
}

double level_of_decibels(double decibels) {
    return (decibels + 100.0) / 70.0;
}
}  // namespace

TEST_CASE("a wave texture has the latest samples of left and right, oldest first, centred at 0.5") {
    const auto texels =
        texels_of([](int i) { return i / 1024.0; }, [](int i) { return i / -2048.0; });
    // 1/60 s has the samples 0 to 799.
    const auto levels = levels_of(texels, {Holds::wave, 2}, 1.0 / 60.0);
    CHECK(levels[0] == doctest::Approx(0.5 + 0.5 * 798 / 1024.0));
    CHECK(levels[1] == doctest::Approx(0.5 + 0.5 * 799 / 1024.0));
    CHECK(levels[3] == doctest::Approx(0.5 - 0.5 * 799 / 2048.0));
    CHECK(levels_of(texels, {Holds::wave, 900}, 1.0 / 60.0)[99] == 0.5f);  // before the sound
}

TEST_CASE("a wave texture with one column has the peak of each channel") {
    const auto texels = texels_of([](int i) { return i == 500 ? -0.6 : 0.1; }, silent);
    const auto levels = levels_of(texels, {Holds::wave, 1}, 1.0 / 60.0);
    CHECK(levels[0] == doctest::Approx(0.8));
    CHECK(levels[1] == 0.5f);
}

TEST_CASE("a spectrum texture has amplitudes from 0 Hz to half the rate, one row per channel") {
    const auto texels =
        texels_of([](int i) { return 0.5 * sine_at(64 * texel_bin_hertz, i / 48000.0); },
                  [](int i) { return 0.25 * sine_at(512 * texel_bin_hertz, i / 48000.0); });
    const auto fine = levels_of(texels, {Holds::spectrum, 1024}, 1.0);
    CHECK(fine[64] == doctest::Approx(0.5).epsilon(1e-4));
    CHECK(fine[200] < 1e-4f);
    CHECK(fine[1024 + 512] == doctest::Approx(0.25).epsilon(1e-4));
    CHECK(fine[1024 + 64] < 1e-4f);
    const auto coarse = levels_of(texels, {Holds::spectrum, 256}, 1.0);
    CHECK(coarse[16] == doctest::Approx(0.5).epsilon(1e-4));
    CHECK(coarse[256 + 128] == doctest::Approx(0.25).epsilon(1e-4));
}

TEST_CASE("the analyser matches Web Audio: Blackman window, decibels from -100 to -30") {
    const auto texels = texels_of(
        [](int i) {
            return 0.02 * sine_at(64 * texel_bin_hertz, i / 48000.0) +
                   1.8 * sine_at(300 * texel_bin_hertz, i / 48000.0);
        },
        silent);
    const auto levels = levels_of(texels, {Holds::analyser, 512}, 2.0);
    // The mean of both channels is 0.01. A transform divided by its size has half of a real sine,
    // times the window's mean of 0.42.
    CHECK(levels[64] ==
          doctest::Approx(level_of_decibels(20.0 * std::log10(0.01 * 0.5 * 0.42))).epsilon(1e-4));
    CHECK(levels[300] == 1.0f);
    CHECK(levels[150] == 0.0f);
}

TEST_CASE("the analyser smooths magnitudes by 0.8 per 1/60 s") {
    const auto texels = texels_of(
        [](int i) {
            return i < texel_rate ? 0.1 * sine_at(64 * texel_bin_hertz, i / 48000.0) : 0.0;
        },
        silent);
    const auto level = [&](int frame) {
        return levels_of(texels, {Holds::analyser, 512}, frame / 60.0)[64];
    };
    const double step = 20.0 * std::log10(0.8) / 70.0;
    CHECK(level(68) - level(67) == doctest::Approx(step).epsilon(1e-3));
    CHECK(level(78) - level(68) == doctest::Approx(10.0 * step).epsilon(1e-3));
}

TEST_CASE("the analyser uses the mean of both channels, and its wave starts 2048 samples ago") {
    const auto opposite = texels_of([](int i) { return 0.5 * sine_at(440.0, i / 48000.0); },
                                    [](int i) { return -0.5 * sine_at(440.0, i / 48000.0); });
    const auto levels = levels_of(opposite, {Holds::analyser, 512}, 1.0);
    CHECK(levels[18] == 0.0f);
    CHECK(levels[512 + 100] == 0.5f);
    const auto ramp = texels_of([](int i) { return i / 65536.0; }, silent);
    CHECK(levels_of(ramp, {Holds::analyser, 512}, 1.0)[512 + 3] ==
          doctest::Approx(0.5 + 0.25 * (48000 - 2048 + 3) / 65536.0));
}

TEST_CASE("sound texels depend only on the time, not on earlier calls") {
    const auto sound = sound_of(
        texel_rate, texel_rate, [](int i) { return sine_at(i * 0.01, i / 48000.0); }, silent);
    const SoundStreamTexels one(stream_of(sound, {}));
    const SoundStreamTexels other(stream_of(sound, {}));
    for (int frame = 1; frame < 40; ++frame)
        (void)levels_of(one, {Holds::analyser, 512}, frame / 60.0);
    const auto in_order = levels_of(one, {Holds::analyser, 512}, 40.0 / 60.0);
    const auto at_once = levels_of(other, {Holds::analyser, 512}, 40.0 / 60.0);
    for (std::size_t i = 0; i < in_order.size(); ++i)
        CHECK(in_order[i] == doctest::Approx(at_once[i]));
}

TEST_CASE("the sound of a beam has x on the left and y on the right") {
    const std::shared_ptr<const Signal> circle =
        signal_of("lissajous:x=2,y=2,phase=0.25,amplitude=0.5");
    const BeamStream stream(circle);
    std::vector<StereoSample> samples(960);
    stream.read(4800, samples);  // 0.1 s, across block boundaries
    float largest_step = 0.0f;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        CHECK(std::hypot(samples[i].left, samples[i].right) == doctest::Approx(0.5).epsilon(1e-3));
        if (i > 0)
            largest_step = std::max(largest_step, std::abs(samples[i].left - samples[i - 1].left));
    }
    CHECK(largest_step < 0.5 * 2.0 * std::numbers::pi * 120.0 / 48000.0 * 1.01);
    // The sound as played for an oscilloscope: its first sample is one step after time 0.
    const Sound played = beam_sound(*circle, {.seconds = 0.2});
    for (std::size_t i = 0; i < samples.size(); ++i)
        CHECK(samples[i].left == doctest::Approx(played.samples[2 * (4800 - 1 + i)]).epsilon(1e-3));
    stream.read(-960, samples);
    CHECK(samples.back() == StereoSample{});
}
