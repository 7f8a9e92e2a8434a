#include "model/devices/midi_clock.h"

#include <doctest/doctest.h>

#include <cstdint>

namespace {
/// A sender with a tempo, whose clock bytes arrive up to `jitter` seconds late.
struct Sender {
    MidiClock clock = {};
    double bpm = 120.0;
    double now = 5.0;
    double jitter = 0.0;
    std::uint32_t state = 1;

    double seconds_per_tick() const { return 60.0 / (bpm * 24.0); }
    void send(std::uint8_t byte) { clock.take(byte, now); }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            state = state * 1664525u + 1013904223u;
            clock.take(0xF8, now + jitter * static_cast<double>(state >> 8) / 16777216.0);
            now += seconds_per_tick();
        }
    }
};
}  // namespace

TEST_CASE("24 clock bytes are a beat, and the song starts with the byte after start") {
    Sender sender;
    sender.send(0xFA);
    sender.run(12);
    CHECK(sender.clock.bpm() == doctest::Approx(120.0));
    CHECK(sender.clock.is_running());
    // The next tick would be number 12.
    CHECK(sender.clock.beats_at(sender.now) == doctest::Approx(0.5));
    sender.run(36);
    CHECK(sender.clock.beats_at(sender.now) == doctest::Approx(2.0));
    CHECK(sender.clock.beats_at(sender.now + 0.25) == doctest::Approx(2.5));
}

TEST_CASE("jitter of five milliseconds changes the tempo by less than 0.2 beats per minute") {
    Sender sender{.bpm = 128.0, .jitter = 0.005};
    sender.send(0xFA);
    sender.run(200);
    CHECK(*sender.clock.bpm() == doctest::Approx(128.0).epsilon(0.2 / 128.0));
    // The mean lateness of 2.5 ms is 0.005 beats.
    CHECK(sender.clock.beats_at(sender.now) == doctest::Approx(200.0 / 24.0).epsilon(0.002));
}

TEST_CASE("a tempo change is detected within a beat") {
    Sender sender;
    sender.send(0xFA);
    sender.run(240);
    sender.bpm = 90.0;
    sender.run(24);
    CHECK(*sender.clock.bpm() == doctest::Approx(90.0).epsilon(0.001));
    CHECK(sender.clock.beats_at(sender.now) == doctest::Approx(11.0).epsilon(0.001));
}

TEST_CASE("stop keeps the position, continue resumes there, start returns to 0") {
    Sender sender;
    sender.send(0xFA);
    sender.run(36);
    sender.send(0xFC);
    sender.run(50);  // many senders keep the clock running
    CHECK_FALSE(sender.clock.is_running());
    CHECK(sender.clock.beats_at(sender.now) == doctest::Approx(1.5));
    CHECK(sender.clock.bpm() == doctest::Approx(120.0));
    sender.send(0xFB);
    sender.run(24);
    CHECK(sender.clock.beats_at(sender.now) == doctest::Approx(2.5));
    sender.send(0xFA);
    sender.run(12);
    CHECK(sender.clock.beats_at(sender.now) == doctest::Approx(0.5));
}

TEST_CASE("a song position counts sixteenths, also with clock bytes in it") {
    Sender sender;
    sender.run(24);
    sender.send(0xF2);
    sender.send(0x05);
    sender.run(1);
    sender.send(0x01);  // 5 + 128 sixteenths
    sender.send(0xFB);
    sender.run(12);
    CHECK(sender.clock.beats_at(sender.now) == doctest::Approx(133.0 / 4.0 + 0.5));
    sender.send(0x90);  // a note, whose data bytes mean nothing here
    sender.send(0x40);
    sender.send(0x40);
    CHECK(sender.clock.beats_at(sender.now) == doctest::Approx(133.0 / 4.0 + 0.5));
}

TEST_CASE("a clock that has ended is absent, and one that returns begins anew") {
    Sender sender;
    CHECK_FALSE(sender.clock.is_present(sender.now));
    sender.run(100);
    CHECK(sender.clock.is_present(sender.now));
    sender.now += 3.0;
    CHECK_FALSE(sender.clock.is_present(sender.now));
    sender.bpm = 60.0;
    sender.run(11);
    CHECK_FALSE(sender.clock.bpm().has_value());
    sender.run(1);
    CHECK(sender.clock.bpm() == doctest::Approx(60.0));
}
