#include "signals/audio/spectrum.h"

#include "signals/audio/beat_detector.h"
#include "signals/signal_making.h"

#include <algorithm>

namespace {
constexpr int spectrum_rate = 48000;
constexpr double bin_hertz = spectrum_rate / 2048.0;

std::shared_ptr<const Sound> sines(double hertz, double amplitude, double other_hertz = 0.0,
                                   double other_amplitude = 0.0) {
    return sound_of(
        spectrum_rate, 2 * spectrum_rate,
        [=](int i) {
            return amplitude * sine_at(hertz, i / 48000.0) +
                   other_amplitude * sine_at(other_hertz, i / 48000.0);
        },
        [](int) { return 0.0; });
}

double level_at(const std::shared_ptr<const Sound>& sound, std::size_t at) {
    const SoundInput input(stream_of(sound, {}), {.channels = SoundChannels::left, .upsample = 1});
    return decibels(Spectrum(input, 2048, 0.0).amplitudes(60)[at]);
}

/// Bursts of 60 Hz for 30 ms, `gap` seconds apart, over quiet hum.
std::shared_ptr<const Sound> clicks(double gap) {
    return sound_of(
        spectrum_rate, 5 * spectrum_rate,
        [=](int i) {
            const double seconds = i / 48000.0;
            const bool is_click = std::fmod(seconds, gap) < 0.03;
            return 0.01 * sine_at(1000.0, seconds) +
                   (is_click ? 0.8 * sine_at(60.0, seconds) : 0.0);
        },
        [](int) { return 0.0; });
}

double ring_radius(const Signal& signal, std::int64_t hop) {
    const Beam beam = beam_of(signal, frame_span(hop + 1, 60.0));
    const BeamPoint& bottom = beam[beam.size() / 2];
    return std::hypot(bottom.x, bottom.y);
}
}  // namespace

TEST_CASE("a full-scale sine at a bin centre reads 0 dB, and 1.42 dB less between bins") {
    CHECK(std::abs(level_at(sines(100 * bin_hertz, 1.0), 100)) < 0.01);
    CHECK(std::abs(level_at(sines(100 * bin_hertz, 0.1), 100) + 20.0) < 0.01);
    // Hann window half a bin off: sin(pi / 2) / (pi / 2) / (1 - 1 / 4) = 8 / (3 pi).
    const double scallop = 20.0 * std::log10(8.0 / (3.0 * std::numbers::pi));
    CHECK(std::abs(level_at(sines(100.5 * bin_hertz, 1.0), 100) - scallop) < 0.01);
    // The Hann window's first neighbours have half the height, further ones none.
    CHECK(std::abs(level_at(sines(100 * bin_hertz, 1.0), 101) + 6.02) < 0.01);
    CHECK(level_at(sines(100 * bin_hertz, 1.0), 110) < -90.0);
}

TEST_CASE("smoothing reaches 63 % after its time constant, at any frame rate") {
    const auto sound = sound_of(
        spectrum_rate, 3 * spectrum_rate,
        [](int i) { return i < spectrum_rate ? 0.0 : sine_at(100 * bin_hertz, i / 48000.0); },
        [](int) { return 0.0; });
    const SoundInput input(stream_of(sound, {}), {.channels = SoundChannels::left, .upsample = 1});
    const Spectrum spectrum(input, 256, 0.25);
    const std::size_t bin = 12;  // 12.5 bins: the tone lies between two
    const double specialized = Spectrum(input, 256, 0.0).amplitudes(120)[bin];
    CHECK(spectrum.amplitudes(60)[bin] < 0.01);
    const double one = 1.0 - std::exp(-1.0);
    CHECK(std::abs(spectrum.amplitudes(60 + 15)[bin] / specialized - one) < 0.01);
    CHECK(std::abs(spectrum.amplitudes(60 + 30)[bin] / specialized - (1.0 - std::exp(-2.0))) <
          0.01);
}

TEST_CASE("two tones have the right position on the log scale, and the right height") {
    const auto sound = sines(20 * bin_hertz, 0.5, 300 * bin_hertz, 0.05);
    const auto signal = signal_of(
        "audio:a.wav,mode=spectrum,channel=left,smoothing=0,low=100,high=10000,floor=-60", sound);
    const Beam beam = beam_of(*signal, frame_span(61, 60.0));
    REQUIRE(beam.size() == 4096);
    struct Tone {
        double hertz;
        double amplitude;
    };
    for (const Tone tone : {Tone{20 * bin_hertz, 0.5}, Tone{300 * bin_hertz, 0.05}}) {
        const double x = 2.0 * std::log(tone.hertz / 100.0) / std::log(100.0) - 1.0;
        const double y = 2.0 * (20.0 * std::log10(tone.amplitude) + 60.0) / 60.0 - 1.0;
        const BeamPoint* best = nullptr;
        for (const BeamPoint& point : beam)
            if (std::abs(point.x - x) < 0.2 && (!best || point.y > best->y))
                best = &point;
        REQUIRE(best);
        CHECK(std::abs(best->x - x) < 0.002);
        CHECK(std::abs(best->y - y) < 0.002);
    }
    CHECK(beam[2000].y == -1.0f);  // between them is the floor
}

TEST_CASE("FFT size, smoothing, floor and ceiling affect the spectrum") {
    const auto highest_at = [](const Signal& signal, double seconds, double hertz) {
        float highest = -1.0f;
        for (const BeamPoint& point : beam_of(signal, {seconds, seconds + 1.0 / 60.0}))
            if (std::abs(0.5 * (point.x + 1.0) - std::log10(hertz / 100.0) / 2.0) < 0.002)
                highest = std::max(highest, point.y);
        return highest;
    };
    const std::string spectrum = "audio:a.wav,mode=spectrum,channel=left,low=100,high=10000,";
    // Two tones 59 Hz apart: 10 bins of 8192 samples, little more than one bin of 1024.
    const auto two = sines(171 * 0.25 * bin_hertz, 0.5, 181 * 0.25 * bin_hertz, 0.5);
    const auto fine = signal_of(spectrum + "smoothing=0,floor=-60,fft=8192", two);
    const auto coarse = signal_of(spectrum + "smoothing=0,floor=-60,fft=1024", two);
    CHECK(highest_at(*fine, 1.0, 1030.0) == -1.0f);
    CHECK(highest_at(*coarse, 1.0, 1030.0) > 0.0f);
    // -20 dB is in the middle of -40 to 0, and at the top of -60 to -20.
    const auto tone = sines(64 * bin_hertz, 0.1);
    const auto at_middle = signal_of(spectrum + "smoothing=0,floor=-40,ceiling=0", tone);
    const auto at_top = signal_of(spectrum + "smoothing=0,floor=-60,ceiling=-20", tone);
    CHECK(std::abs(highest_at(*at_middle, 1.0, 64 * bin_hertz)) < 0.01f);
    CHECK(std::abs(highest_at(*at_top, 1.0, 64 * bin_hertz) - 1.0f) < 0.01f);
    // 0.5 s after its start a tone has 1 - e^-1 of its amplitude: 3.99 dB less.
    const auto late = sound_of(
        spectrum_rate, 3 * spectrum_rate,
        [](int i) { return i < spectrum_rate ? 0.0 : sine_at(64 * bin_hertz, i / 48000.0); },
        [](int) { return 0.0; });
    const auto slow = signal_of(spectrum + "smoothing=0.5,floor=-20,fft=256,loop=off", late);
    const auto at_once = signal_of(spectrum + "smoothing=0,floor=-20,fft=256,loop=off", late);
    const double missing =
        10.0 * (highest_at(*at_once, 1.5, 64 * bin_hertz) - highest_at(*slow, 1.5, 64 * bin_hertz));
    CHECK(std::abs(missing + 20.0 * std::log10(1.0 - std::exp(-1.0))) < 0.1);
}

TEST_CASE("frequencies above half the rate are at the floor, and an empty range is an error") {
    const auto sound = sound_of(
        8000, 8000, [](int i) { return i % 2 == 0 ? 0.9 : -0.9; }, [](int) { return 0.0; });
    const Beam beam = beam_of(*signal_of("audio:a.wav,mode=spectrum,low=4100,high=20000", sound),
                              frame_span(31, 60.0));
    CHECK(std::all_of(beam.begin(), beam.end(),
                      [](const BeamPoint& point) { return point.y == -1.0f; }));
    for (const char* text : {"audio:a.wav,mode=spectrum,low=500,high=100",
                             "audio:a.wav,mode=radial,floor=-10,ceiling=-20"})
        CHECK_FALSE(make_signal(parse_spec(text).value(), {sound}).has_value());
}

TEST_CASE("a click track of 120 BPM has one beat every half second") {
    const auto sound = clicks(0.5);
    const SoundInput input(stream_of(sound, {}), {.channels = SoundChannels::left, .upsample = 1});
    const BeatDetector beats(input, 2.0);
    std::vector<double> found;
    for (int i = 0; i < 450; ++i) {
        const auto beat = beats.last_beat(i / 100.0);
        if (beat && (found.empty() || *beat != found.back()))
            found.push_back(*beat);
    }
    REQUIRE(found.size() == 9);
    for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK(found[i] > static_cast<double>(i) * 0.5);
        CHECK(found[i] <= static_cast<double>(i) * 0.5 + 0.0201);
    }
    const BeatDetector deaf(input, 200.0);
    CHECK_FALSE(deaf.last_beat(4.0).has_value());
}

TEST_CASE("silence and a steady tone have no beats") {
    for (const double amplitude : {0.0, 0.5}) {
        const auto sound = sines(60.0, amplitude);
        const SoundInput input(stream_of(sound, {.loops = true}),
                               {.channels = SoundChannels::left, .upsample = 1});
        CHECK_FALSE(BeatDetector(input, 2.0).last_beat(3.0).has_value());
    }
}

TEST_CASE("radial: the ring pulses on a beat and decays with its time constant") {
    const auto signal = signal_of(
        "audio:a.wav,mode=radial,channel=left,radius=0.4,pulse=0.5,beat_decay=0.1,floor=-20",
        clicks(0.5));
    const double before = ring_radius(*signal, 149);  // the last frame before the beat at 2.5 s
    const double after = ring_radius(*signal, 152);
    const double later = ring_radius(*signal, 158);
    const auto deaf =
        signal_of("audio:a.wav,mode=radial,channel=left,radius=0.4,floor=-20,beat_threshold=200",
                  clicks(0.5));
    CHECK(ring_radius(*deaf, 152) == doctest::Approx(0.4).epsilon(0.01));
    CHECK(before == doctest::Approx(0.4).epsilon(0.01));
    CHECK(after > 0.5);
    CHECK((later - 0.4) / (after - 0.4) == doctest::Approx(std::exp(-1.0)).epsilon(0.02));
    const Beam ring = beam_of(*signal, frame_span(150, 60.0));
    CHECK(std::abs(ring.front().x) < 0.002);  // it starts at the top
    CHECK(ring.front().y > 0.39f);
    CHECK(ring[1024].x == doctest::Approx(-ring[3070].x).epsilon(1e-3));  // symmetric
}

TEST_CASE("automatic gain raises the spectrum of a quiet sound by at most 40 dB") {
    const auto peak = [](const std::string& gain, double amplitude) {
        const auto signal =
            signal_of("audio:a.wav,mode=spectrum,floor=-100,ceiling=0,smoothing=0," + gain,
                      sines(40 * bin_hertz, 2.0 * amplitude));
        const Beam beam = beam_of(*signal, frame_span(100, 60.0));
        return 50.0 *
               (std::max_element(beam.begin(), beam.end(),
                                 [](const BeamPoint& a, const BeamPoint& b) { return a.y < b.y; })
                    ->y -
                1.0);
    };
    CHECK(std::abs(peak("auto_gain=off", 0.05) - 20.0 * std::log10(0.05)) < 0.05);
    CHECK(std::abs(peak("auto_gain=on", 0.05) + 6.02) < 0.1);  // only left: the mean is half
    CHECK(std::abs(peak("auto_gain=on", 0.0005) - 20.0 * std::log10(0.05)) < 0.1);
}
