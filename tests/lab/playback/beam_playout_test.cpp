#include "lab/no_sound_devices.h"
#include "lab/playback/player.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {
constexpr int playout_rate = 48000;
constexpr double playout_frame = 1.0 / 60.0;

/// A simulated oscilloscope at a sound device.
struct Scope {
    BeamQueue queue{playout_rate};
    bool has_stalled = false;
    int opened = 0;

    /// The samples that it gets in a time, at full scale: x and y interleaved.
    std::vector<float> see(int frames) {
        std::vector<float> stereo(2 * static_cast<std::size_t>(frames));
        queue.mix(stereo);
        return stereo;
    }
};

class ScopeOutput : public BeamOutput {
public:
    explicit ScopeOutput(Scope& scope) : m_scope(scope) { ++m_scope.opened; }
    ~ScopeOutput() override { --m_scope.opened; }

    std::string device_name() const override { return "Scope"; }
    int rate() const override { return playout_rate; }
    BeamQueue& queue() override { return m_scope.queue; }
    bool has_stalled() const override { return m_scope.has_stalled; }

private:
    Scope& m_scope;
};

/// A machine without audio devices that names the beam in its error.
class MissingDevices : public NoSoundDevices {
public:
    Result<std::unique_ptr<BeamOutput>> open_beam_output(const SoundSettings&) override {
        return fail({{}, 0, "no device for a beam"});
    }
};

class ScopeDevices : public NoSoundDevices {
public:
    explicit ScopeDevices(Scope& scope) : m_scope(scope) {}

    Result<std::unique_ptr<BeamOutput>> open_beam_output(const SoundSettings&) override {
        return std::make_unique<ScopeOutput>(m_scope);
    }

private:
    Scope& m_scope;
};

SoundSettings beam_switched(bool is_on) {
    SoundSettings settings;
    settings.plays_beam = is_on;
    settings.beam_level = 1.0;
    return settings;
}

/// A player whose beam goes to a scope at full level.
struct Bench {
    Bench() : player(std::make_unique<ScopeDevices>(scope)) {
        REQUIRE(player.set_sound_settings(beam_switched(true)).has_value());
        REQUIRE(
            player.set_signal(parse_spec("lissajous:x=3,y=2,amplitude=0.8").value()).has_value());
    }

    /// Advances time and returns the output to the scope: `frames` samples for each frame of 1/60
    /// s.
    std::vector<float> run(double seconds, int frames = playout_rate / 60) {
        std::vector<float> played;
        for (int i = 0; i < std::lround(seconds * 60.0); ++i) {
            player.advance(playout_frame);
            const std::vector<float> some = scope.see(frames);
            played.insert(played.end(), some.begin(), some.end());
        }
        return played;
    }

    Scope scope;
    Player player;
};

float largest_step(const std::vector<float>& stereo) {
    float step = 0.0f;
    for (std::size_t i = 2; i < stereo.size(); ++i)
        step = std::max(step, std::abs(stereo[i] - stereo[i - 2]));
    return step;
}

// Three periods in 1/60 s change by at most 2 pi 180 * 0.8 per second. A jump is spread over 5 ms.
const float steepest = static_cast<float>(0.8 * 2.0 * std::numbers::pi * 180.0 / playout_rate +
                                          1.6 / (playout_rate * 0.005));
}  // namespace

TEST_CASE("a scope gets x on the left and y on the right, at the device's rate") {
    Bench bench;
    bench.run(0.1);
    const double start = bench.player.transport().time();
    const std::vector<float> played = bench.run(1.0);
    double largest = 0.0;
    for (std::size_t i = 0; i < played.size() / 2; ++i) {
        // The picture and the samples of a time start together.
        const double turns =
            60.0 * (start + playout_frame + static_cast<double>(i + 1) / playout_rate);
        const double x = 0.8 * std::sin(2.0 * std::numbers::pi * (3.0 * turns + 0.25));
        const double y = 0.8 * std::sin(2.0 * std::numbers::pi * 2.0 * turns);
        largest = std::max({largest, std::abs(static_cast<double>(played[2 * i]) - x),
                            std::abs(static_cast<double>(played[2 * i + 1]) - y)});
    }
    CHECK(largest < 0.02);
}

TEST_CASE("seeks, new signals, pause and play cause no click, and a paused beam is still") {
    Bench bench;
    std::vector<float> played = bench.run(0.5);
    const auto go_on = [&](double seconds) {
        std::vector<float> more = bench.run(seconds);
        played.insert(played.end(), more.begin(), more.end());
        return more;
    };
    bench.player.seek(123.4567);
    go_on(0.3);
    REQUIRE(
        bench.player.set_signal(parse_spec("lissajous:x=1,y=1,amplitude=0.8").value()).has_value());
    go_on(0.3);
    bench.player.pause();
    const std::vector<float> rest = go_on(0.1);
    CHECK(rest.front() == rest[rest.size() - 2]);
    bench.player.play();
    const std::vector<float> again = go_on(0.3);
    CHECK(again.front() != again[1000]);
    CHECK(largest_step(played) <= steepest * 1.01f);
    CHECK(largest_step(played) > 0.01f);
}

TEST_CASE("a device with another clock than the picture is followed without a gap") {
    for (const int frames : {799, 801}) {
        Bench bench;
        bench.run(1.0, frames);
        // No join: a join after a gap is steeper than the signal.
        CHECK(largest_step(bench.run(30.0, frames)) <=
              0.8f * 2.0f * 3.15f * 180.0f / playout_rate * 1.02f);
        CHECK(bench.scope.queue.waiting() > playout_rate / 20);
        CHECK(bench.scope.queue.waiting() < playout_rate / 5);
    }
}

TEST_CASE("time that a slow machine does not show is skipped, because a scope cannot wait") {
    Bench bench;
    bench.player.set_longest_frame(0.05);
    CHECK(bench.player.devices().plays_in_real_time());
    for (int i = 0; i < 20; ++i) {
        bench.player.advance(0.1);
        bench.scope.see(playout_rate / 10);
    }
    CHECK(std::abs(bench.player.transport().time() - 2.0) < 1e-6);
}

TEST_CASE("a lost scope device is reported, and switching off releases it") {
    Bench bench;
    CHECK(bench.scope.opened == 1);
    CHECK(bench.player.devices().beam_device() == "Scope");
    bench.scope.has_stalled = true;
    bench.run(0.1);
    CHECK(bench.player.error() == "Audio device \"Scope\" stopped. The beam isn't sent any more.");
    REQUIRE(bench.player.set_sound_settings(beam_switched(false)).has_value());
    CHECK(bench.scope.opened == 0);
    CHECK(bench.player.error().empty());
    REQUIRE(bench.player.advance(playout_frame).has_value());
}

TEST_CASE("without a device the switch resets, this is reported and the picture continues") {
    const auto sound =
        std::make_shared<const Sound>(Sound{1000, 2, std::vector<float>(2000, 0.5f)});
    for (const char* signal : {"lissajous", "audio:a.wav"}) {
        CAPTURE(signal);
        Player player(std::make_unique<MissingDevices>());
        const Spec spec = parse_spec(signal).value();
        const bool is_sound = spec.kind == "audio";
        REQUIRE(player.set_signal(spec, is_sound ? SignalFile{"a.wav", sound} : SignalFile{})
                    .has_value());
        CHECK(player.error() == (is_sound ? "no audio device found" : ""));
        REQUIRE(player.set_sound_settings(beam_switched(true)).has_value());
        CHECK(player.error() == "no device for a beam");
        CHECK_FALSE(player.devices().settings().plays_beam);
        REQUIRE(player.advance(playout_frame).has_value());
    }
}
