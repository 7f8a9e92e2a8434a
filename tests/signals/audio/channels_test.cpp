// The channels of a sound as position, current and colour of the beam.
#include "about.h"
#include "signals/audio/audio.h"
#include "signals/signal_making.h"

namespace {
constexpr int channels_rate = 6000;  // 100 samples in 1/60 s

/// A sound with `channels` channels: channel c of sample i is value(c, i), c from 1.
template <class Value>
std::shared_ptr<const Sound> channels_of(int channels, int frames, const Value& value) {
    auto sound = std::make_shared<Sound>(Sound{channels_rate, channels, {}});
    for (int i = 0; i < frames; ++i)
        for (int channel = 1; channel <= channels; ++channel)
            sound->samples.push_back(static_cast<float>(value(channel, i)));
    return sound;
}

// All channels differ at every sample.
double stair(int channel, int sample) {
    return 0.1 * channel + 0.0001 * sample;
}

Beam second_frame(const std::string& settings, std::shared_ptr<const Sound> sound) {
    return beam_of(*signal_of("audio:a.wav,upsample=1," + settings, std::move(sound)),
                   frame_span(2, 60.0));
}

std::string channels_refusal(const std::string& text, std::shared_ptr<const Sound> sound) {
    const auto signal = make_signal(parse_spec(text).value(), {std::move(sound)});
    REQUIRE_FALSE(signal.has_value());
    return signal.error().front().message;
}
}  // namespace

TEST_CASE("x, y, red, green and blue are taken from the chosen channels") {
    const Beam beam = second_frame("x=5,y=4,r=3,g=2,b=1", channels_of(5, 600, stair));
    REQUIRE(beam.size() == 100);
    REQUIRE(beam.tints.size() == 100);
    for (std::size_t i = 0; i < beam.size(); ++i) {
        const int sample = 100 + static_cast<int>(i);
        const auto value = [&](int channel) { return static_cast<float>(stair(channel, sample)); };
        REQUIRE(beam[i].x == value(5));
        REQUIRE(beam[i].y == value(4));
        REQUIRE(beam.tints[i] == BeamTint{value(3), value(2), value(1)});
    }
}

TEST_CASE("the intensity channel multiplies the current, and negative values blank the beam") {
    const auto sound = channels_of(3, 600, [](int channel, int i) {
        return channel < 3 ? 0.5 : i % 2 == 0 ? 0.25 : -0.25;
    });
    const Beam lit = second_frame("mode=xy", sound);
    const Beam beam = second_frame("intensity=3", sound);
    REQUIRE(beam.size() == lit.size());
    for (std::size_t i = 0; i < beam.size(); ++i)
        REQUIRE(beam[i].intensity == (i % 2 == 0 ? 0.25f * lit[i].intensity : 0.0f));
    CHECK(beam.tints.empty());
}

TEST_CASE("without a channel a position is 0, and a colour is dark if another colour has one") {
    const auto sound = channels_of(4, 600, stair);
    for (const BeamPoint& point : second_frame("x=0,y=3", sound)) {
        REQUIRE(point.x == 0.0f);
        REQUIRE(point.y != 0.0f);
    }
    const Beam red = second_frame("r=4", sound);
    REQUIRE(red.tints.size() == red.size());
    for (const BeamTint& tint : red.tints) {
        REQUIRE(tint.r > 0.4f);
        REQUIRE(tint.g == 0.0f);
        REQUIRE(tint.b == 0.0f);
    }
}

TEST_CASE("without colour channels there are no tints, and the beam is unchanged") {
    const auto sound = channels_of(2, 600, stair);
    const Beam plain = second_frame("mode=xy", sound);
    CHECK(plain.tints.empty());
    CHECK(plain == second_frame("x=1,y=2,intensity=0", sound));
}

TEST_CASE("current and colour are interpolated linearly, and are not affected by the level") {
    const auto sound = channels_of(3, 600, [](int, int i) { return i * 0.001; });
    const Beam beam = beam_of(*signal_of("audio:a.wav,upsample=4,level=2,intensity=3,r=3", sound),
                              frame_span(2, 60.0));
    REQUIRE(beam.size() == 400);
    for (std::size_t i = 0; i < beam.size(); ++i) {
        const double value = 0.1 + static_cast<double>(i) / 4.0 * 0.001;
        REQUIRE(std::abs(beam.tints[i].r - value) < 1e-6);
        REQUIRE(std::abs(beam[i].intensity / (4096.0 * 60.0 / (4.0 * channels_rate)) - value) <
                1e-5);
    }
}

TEST_CASE(
    "the colours do not depend on the division into frames, also in a loop and after the end") {
    const auto sound = channels_of(6, 250, stair);
    for (const char* loop : {"on", "off"}) {
        const auto signal =
            signal_of(std::string("audio:a.wav,intensity=3,r=4,g=5,b=6,loop=") + loop, sound);
        Beam whole = beam_of(*signal, {0.0, 0.1});
        Beam pieces;
        for (int i = 0; i < 7; ++i)
            signal->trace({0.1 * i / 7.0, 0.1 * (i + 1) / 7.0}, pieces);
        REQUIRE(whole.tints.size() == whole.size());
        REQUIRE(pieces.tints == whole.tints);
        for (std::size_t i = 0; i < whole.size(); ++i)
            REQUIRE(pieces[i].intensity == whole[i].intensity);
    }
}

TEST_CASE("a channel number beyond the sound is an error, and mono is x and y") {
    const auto stereo = channels_of(2, 600, stair);
    CHECK(channels_refusal("audio:a.wav,r=5", stereo) ==
          "'r' is channel 5, but the sound has only 2 channels");
    const auto mono = channels_of(1, 600, stair);
    CHECK(channels_refusal("audio:a.wav,x=2", mono) ==
          "'x' is channel 2, but the sound has only 1 channel");
    const Beam diagonal = second_frame("mode=xy", mono);
    CHECK(diagonal.back().x == diagonal.back().y);
    CHECK(make_signal(parse_spec("audio:a.wav,mode=spectrum,r=5").value(), {stereo}).has_value());
}

TEST_CASE("channels of a live sound are selected the same way") {
    auto live = std::make_shared<LiveSound>(channels_rate, 4);
    std::vector<float> samples;
    for (int i = 0; i < 200; ++i)
        for (int channel = 1; channel <= 4; ++channel)
            samples.push_back(static_cast<float>(stair(channel, i)));
    live->write(samples, 4);
    SignalMedia media;
    media.live = live;
    const auto signal = make_signal(parse_spec("microphone:upsample=1,x=4,y=3,g=2").value(), media);
    REQUIRE(signal.has_value());
    const Beam beam = beam_of(**signal, frame_span(1, 60.0));
    REQUIRE(beam.tints.size() == 100);
    CHECK(beam[50].x == static_cast<float>(stair(4, 50)));
    CHECK(beam[50].y == static_cast<float>(stair(3, 50)));
    CHECK(beam.tints[50] == BeamTint{0.0f, static_cast<float>(stair(2, 50)), 0.0f});
    CHECK_FALSE(make_signal(parse_spec("microphone:b=5").value(), media).has_value());
}
