#include "lab/playback/player.h"

#include "lab/no_sound_devices.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
constexpr double frame_seconds = 1.0 / 60.0;

/// A simulated input device.
class FakeCapture : public SoundCapture {
public:
    explicit FakeCapture(double& position, bool& has_stalled)
        : m_position(position), m_has_stalled(has_stalled) {}

    std::string device_name() const override { return "Line in"; }
    std::shared_ptr<const LiveSound> sound() const override { return live; }
    double position_seconds() override { return m_position; }
    bool has_stalled() const override { return m_has_stalled; }

    std::shared_ptr<LiveSound> live = std::make_shared<LiveSound>(1000);

private:
    double& m_position;
    bool& m_has_stalled;
};

class FakeDevices : public SoundDevices {
public:
    std::vector<SoundDevice> list() override { return {{.name = "Line in", .has_input = true}}; }
    Result<std::unique_ptr<SoundOutput>> open_output(const SoundSettings&) override {
        return fail({{}, 0, "no audio device found"});
    }
    Result<std::unique_ptr<BeamOutput>> open_beam_output(const SoundSettings&) override {
        return fail({{}, 0, "no audio device found"});
    }
    Result<std::unique_ptr<SoundCapture>> open_capture(const SoundSettings& settings,
                                                       int) override {
        if (settings.input == "Gone")
            return fail({{}, 0, "can't open the audio input: 'Gone' isn't connected"});
        ++captures;
        asked = settings;
        auto capture = std::make_unique<FakeCapture>(position, has_stalled);
        live = capture->live;
        return capture;
    }

    double position = 5.0;
    bool has_stalled = false;
    int captures = 0;
    SoundSettings asked;  // of the last capture
    std::shared_ptr<LiveSound> live;
};

/// A player with simulated devices.
struct LivePlayer {
    LivePlayer() : LivePlayer(std::make_unique<FakeDevices>()) {}
    explicit LivePlayer(std::unique_ptr<FakeDevices> made)
        : devices(*made), player(std::move(made)) {}

    FakeDevices& devices;
    Player player;
};

SignalFile second_of_sound() {
    return {"a.wav", std::make_shared<const Sound>(Sound{1000, 2, std::vector<float>(2000, 0.5f)})};
}
}  // namespace

TEST_CASE("frames join without a gap, and their numbers start at 1") {
    Player player;
    double end = 0.0;
    for (int i = 1; i <= 100; ++i) {
        const auto frame = player.advance(i % 3 == 0 ? 0.031 : 0.007);
        REQUIRE(frame.has_value());
        CHECK(frame->number == i);
        CHECK(frame->span.start == end);
        end = frame->span.end;
    }
    CHECK(end == doctest::Approx(33 * 0.031 + 67 * 0.007));
}

TEST_CASE("speed scales time within 0.01 and 4") {
    Player player;
    player.set_speed(2.0);
    CHECK(player.advance(0.1)->span.end == doctest::Approx(0.2));
    player.set_speed(1000.0);
    CHECK(player.transport().speed() == 4.0);
    player.set_speed(0.0);
    CHECK(player.transport().speed() == 0.01);
}

TEST_CASE("while paused there is no frame, and a step is 1/60 s") {
    Player player;
    player.advance(0.05);
    player.pause();
    CHECK_FALSE(player.advance(0.05).has_value());
    player.step();
    const auto frame = player.advance(0.05);
    REQUIRE(frame.has_value());
    CHECK(frame->span.seconds() == doctest::Approx(frame_seconds));
    CHECK_FALSE(player.advance(0.05).has_value());
    player.play();
    CHECK(player.advance(0.05).has_value());
}

TEST_CASE("restart begins at frame 1 and time 0 without history, and seeking keeps the count") {
    Player player;
    player.advance(0.05);
    player.seek(7.0);
    const auto sought = player.advance(0.05);
    CHECK(sought->span.start == 7.0);
    CHECK(sought->number == 2);
    CHECK(player.transport().past().size() == 2);
    player.restart();
    CHECK(player.transport().past().empty());
    CHECK(player.advance(0.05)->number == 1);
}

TEST_CASE("a delayed window drops time instead of drawing it in one frame") {
    Player player;
    CHECK(player.advance(100.0)->span.seconds() == doctest::Approx(0.25));
}

TEST_CASE("a limit per frame slows the shown time down, and the share is reported") {
    Player player;
    CHECK(player.transport().shown_share() == 1.0);
    player.set_longest_frame(0.05);
    double end = 0.0;
    for (int i = 0; i < 60; ++i) {
        const auto frame = player.advance(0.6);  // duration of a frame on a slow machine
        CHECK(frame->span.start == end);         // no time is skipped
        CHECK(frame->span.seconds() == doctest::Approx(0.05));
        end = frame->span.end;
    }
    CHECK(player.transport().shown_share() == doctest::Approx(0.05 / 0.6).epsilon(0.01));
    player.set_longest_frame(1.0);  // at most a quarter of a second in any case
    CHECK(player.advance(0.6)->span.seconds() == doctest::Approx(0.25));
    for (int i = 0; i < 180; ++i)
        player.advance(frame_seconds);
    CHECK(player.transport().shown_share() == doctest::Approx(1.0).epsilon(0.01));
}

TEST_CASE("the reported share is right from the second slow frame on, for any duration") {
    Player player;
    for (int i = 0; i < 60; ++i)
        player.advance(frame_seconds);
    player.advance(1.8);
    CHECK(player.transport().shown_share() == 1.0);  // a single frame may be delayed by anything
    player.advance(1.8);
    CHECK(player.transport().shown_share() == doctest::Approx(0.25 / 1.8));
    player.advance(1.8);
    CHECK(player.transport().shown_share() == doctest::Approx(0.25 / 1.8));
}

TEST_CASE("a single delayed frame does not slow time down") {
    Player player;
    for (const double seconds : {frame_seconds, 3.0, frame_seconds, frame_seconds}) {
        player.advance(seconds);
        CHECK(player.transport().shown_share() == 1.0);
    }
}

TEST_CASE("frame N of the fixed clock ends at N/fps") {
    Player player;
    for (int n = 1; n <= 3; ++n) {
        const PlayedFrame frame = player.advance_fixed(24.0);
        CHECK(frame.number == n);
        CHECK(frame.span.start == doctest::Approx((n - 1) / 24.0));
        CHECK(frame.span.end == doctest::Approx(n / 24.0));
    }
}

TEST_CASE("a signal is created over its sound, and an unknown one keeps the last one") {
    Player player;
    REQUIRE(player
                .set_signal(Spec{"audio", {{"file", std::string("a.wav")}, {"start", 0.25}}},
                            second_of_sound())
                .has_value());
    CHECK(player.signal().sound_seconds() == doctest::Approx(0.75));
    const Signal* before = player.signal().get();
    CHECK_FALSE(player.set_signal(Spec{"no such kind", {}}).has_value());
    CHECK(player.signal().get() == before);
    CHECK(player.signal().sound().sound != nullptr);
    REQUIRE(player.set_signal(Spec{"lissajous", {}}).has_value());
    CHECK(player.signal().sound_seconds() == 0.0);
    CHECK_FALSE(player.signal().trace({0.0, frame_seconds}).empty());
    REQUIRE(player.set_signal({}).has_value());
    CHECK(player.signal().trace({0.0, frame_seconds}).empty());
}

TEST_CASE("live sound is the clock, and input is drawn at its own time") {
    LivePlayer live;
    live.player.advance(0.1);
    REQUIRE(live.player.set_signal(Spec{"microphone", {{"upsample", 1.0}}}).has_value());
    CHECK(live.player.signal().live_input().device_name() == "Line in");
    CHECK_FALSE(live.player.advance(0.5).has_value());  // no input since then
    live.devices.live->write(std::vector<float>(2 * 5000, 0.0f), 2);
    live.devices.live->write(std::vector<float>(2 * 100, 0.25f), 2);
    live.devices.position = 5.1;
    const auto frame = live.player.advance(0.0);
    REQUIRE(frame.has_value());
    CHECK(frame->span.start == doctest::Approx(0.1));
    CHECK(frame->span.end == doctest::Approx(0.2));
    const Beam beam = live.player.signal().trace(frame->span);
    REQUIRE(beam.size() == 100);
    CHECK(beam.front().x == 0.25f);
    CHECK(beam.back().y == 0.25f);
}

TEST_CASE("input during a pause is skipped, and a restart begins at the present") {
    LivePlayer live;
    REQUIRE(live.player.set_signal(Spec{"microphone", {}}).has_value());
    live.player.pause();
    live.devices.position = 9.0;
    CHECK_FALSE(live.player.advance(0.1).has_value());
    live.player.play();
    CHECK(live.player.advance(0.1)->span.seconds() == doctest::Approx(0.25));
    live.player.restart();
    live.devices.position = 9.1;
    const auto frame = live.player.advance(0.1);
    CHECK(frame->number == 1);
    CHECK(frame->span.end == doctest::Approx(0.1));
}

TEST_CASE("the picture of a live sound is late by the chosen delay") {
    LivePlayer live;
    REQUIRE(live.player.set_signal(Spec{"microphone", {}}).has_value());
    SoundSettings late;
    late.picture_delay_ms = 100.0;
    REQUIRE(live.player.set_sound_settings(late).has_value());
    live.devices.position = 5.15;
    const auto frame = live.player.advance(0.0);
    REQUIRE(frame.has_value());
    CHECK(frame->span.end == doctest::Approx(0.05));
}

TEST_CASE("another input, rate or buffer reopens the input") {
    LivePlayer live;
    REQUIRE(live.player.set_signal(Spec{"microphone", {}}).has_value());
    SoundSettings other;
    other.input = "Monitor of speakers";
    REQUIRE(live.player.set_sound_settings(other).has_value());
    CHECK(live.devices.asked == other);
    other.rate = 96000;
    REQUIRE(live.player.set_sound_settings(other).has_value());
    CHECK(live.devices.asked == other);
    other.buffer = 128;
    REQUIRE(live.player.set_sound_settings(other).has_value());
    CHECK(live.devices.asked == other);
    CHECK(live.devices.captures == 4);
}

TEST_CASE("a missing input is reported, and the last signal continues") {
    LivePlayer live;
    REQUIRE(live.player.set_signal(Spec{"lissajous", {}}).has_value());
    SoundSettings gone;
    gone.input = "Gone";
    REQUIRE(live.player.set_sound_settings(gone).has_value());
    const auto set = live.player.set_signal(Spec{"microphone", {}});
    REQUIRE_FALSE(set.has_value());
    CHECK(live.player.error() == "can't open the audio input: 'Gone' isn't connected");
    CHECK_FALSE(live.player.signal().trace(live.player.advance(0.1)->span).empty());
}

TEST_CASE("an input that stops is reported, and time continues") {
    LivePlayer live;
    REQUIRE(live.player.set_signal(Spec{"microphone", {}}).has_value());
    live.devices.has_stalled = true;
    CHECK(live.player.advance(0.1)->span.seconds() == doctest::Approx(0.1));
    CHECK(live.player.error() == "No input from \"Line in\"");
}

TEST_CASE("a muted live sound draws a still beam, and its device stays closed") {
    LivePlayer live;
    REQUIRE(live.player.mute_input(true).has_value());
    REQUIRE(live.player.set_signal(Spec{"microphone", {{"upsample", 1.0}}}).has_value());
    CHECK(live.devices.captures == 0);
    CHECK(live.player.signal().is_live());
    CHECK(live.player.signal().live_input().is_muted());
    CHECK(live.player.error() == "Live sound is muted");
    const auto frame = live.player.advance(0.1);  // the machine's clock continues
    REQUIRE(frame.has_value());
    for (const BeamPoint& point : live.player.signal().trace(frame->span)) {
        CHECK(point.x == 0.0f);
        CHECK(point.y == 0.0f);
    }
    REQUIRE(live.player.mute_input(false).has_value());
    CHECK(live.devices.captures == 1);
    CHECK(live.player.signal().live_input().device_name() == "Line in");
    CHECK(live.player.error().empty());
    REQUIRE(live.player.mute_input(true).has_value());
    CHECK(live.player.signal().live_input().device_name().empty());
}

TEST_CASE("the input is open only while it is drawn, and value changes do not reopen it") {
    LivePlayer live;
    REQUIRE(live.player.set_signal(Spec{"microphone", {}}).has_value());
    REQUIRE(live.player.set_signal(Spec{"microphone", {{"level", 2.0}}}).has_value());
    CHECK(live.devices.captures == 1);
    REQUIRE(live.player.set_signal(Spec{"lissajous", {}}).has_value());
    CHECK(live.player.signal().live_input().device_name().empty());
}

namespace {
/// A simulated loudspeaker.
struct Loudspeaker {
    double position = 0.0;
    bool is_connected = true;
    bool has_sound = false;
    bool has_stalled = false;
};

class FakeOutput : public SoundOutput {
public:
    explicit FakeOutput(Loudspeaker& loudspeaker) : m_loudspeaker(loudspeaker) {}

    std::string device_name() const override { return "Line out"; }
    void play(std::shared_ptr<const Sound> sound, double, double) override {
        m_loudspeaker.has_sound = sound != nullptr;
    }
    void play() override {}
    void pause() override {}
    void seek(double seconds) override { m_loudspeaker.position = seconds; }
    void set_loop(bool) override {}
    void set_level(double) override {}
    void set_speed(double) override {}
    double position_seconds() override { return m_loudspeaker.position; }
    bool has_stalled() const override { return m_loudspeaker.has_stalled; }

private:
    Loudspeaker& m_loudspeaker;
};

class OutputDevices : public NoSoundDevices {
public:
    explicit OutputDevices(Loudspeaker& loudspeaker) : m_loudspeaker(loudspeaker) {}

    Result<std::unique_ptr<SoundOutput>> open_output(const SoundSettings&) override {
        if (!m_loudspeaker.is_connected)
            return fail({{}, 0, "no audio device found"});
        return std::make_unique<FakeOutput>(m_loudspeaker);
    }

private:
    Loudspeaker& m_loudspeaker;
};
}  // namespace

TEST_CASE("an audible sound is the clock, and time continues when its device is lost") {
    Loudspeaker loudspeaker;
    Player player(std::make_unique<OutputDevices>(loudspeaker));
    REQUIRE(player.set_signal(parse_spec("audio:a.wav").value(), second_of_sound()).has_value());
    loudspeaker.position = 0.02;
    CHECK(player.advance(0.1)->span.end == doctest::Approx(0.02));
    CHECK(player.error().empty());
    loudspeaker.has_stalled = true;
    CHECK(player.advance(0.1)->span.end == doctest::Approx(0.12));
    CHECK(player.error() == "Audio device \"Line out\" stopped. Playing silently.");
}

TEST_CASE("a sound plays on a device that was connected later") {
    Loudspeaker loudspeaker{.is_connected = false};
    Player player(std::make_unique<OutputDevices>(loudspeaker));
    const Spec spec = parse_spec("audio:a.wav").value();
    const SignalFile sound = second_of_sound();
    REQUIRE(player.set_signal(spec, sound).has_value());
    CHECK(player.error() == "no audio device found");
    loudspeaker.is_connected = true;
    REQUIRE(player.set_signal(spec, sound).has_value());
    CHECK(loudspeaker.has_sound);
    CHECK(player.error().empty());
}

TEST_CASE("seeking with a past fills the history as if the frames had been shown") {
    Player player;
    player.seek_with_past(2.0, 30);
    CHECK(player.transport().time() == doctest::Approx(2.0));
    CHECK(player.transport().frame_number() == 120);
    REQUIRE(player.transport().past().size() == 30);
    CHECK(player.transport().past().front().number == 91);
    CHECK(player.transport().past().front().span.start == doctest::Approx(1.5));
    CHECK(player.transport().past().back().span.end == doctest::Approx(2.0));
    CHECK(player.transport().past().back().span.seconds() == doctest::Approx(frame_seconds));

    player.seek_with_past(0.1, 30);  // there are no earlier frames
    CHECK(player.transport().past().size() == 6);
    CHECK(player.transport().past().front().number == 1);
    player.seek_with_past(0.0, 30);
    CHECK(player.transport().past().empty());
}

TEST_CASE("sound textures follow the player's signal, and without a signal there are none") {
    Player player;
    CHECK_FALSE(player.signal().sound_texels());
    REQUIRE(player.set_signal(parse_spec("lissajous:x=2,y=2,phase=0.25,amplitude=0.5").value())
                .has_value());
    REQUIRE(player.signal().sound_texels());
    std::array<float, 8> levels{};
    player.signal().sound_texels()->read({SoundTexture::Holds::wave, 4}, 1.0, levels);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(std::hypot(2.0f * levels[i] - 1.0f, 2.0f * levels[i + 4] - 1.0f) ==
              doctest::Approx(0.5).epsilon(1e-3));
    REQUIRE(player.set_signal({}).has_value());
    CHECK_FALSE(player.signal().sound_texels());
}
