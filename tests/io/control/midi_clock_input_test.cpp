#include "io/control/midi_clock_input.h"

#include <doctest/doctest.h>

#include <array>

namespace {
constexpr std::array<unsigned char, 1> clock_tick{0xF8};

// `count` ticks at 120 beats per minute; returns the time after them.
double run(MidiClockInput& input, std::size_t device, int count, double seconds) {
    for (int i = 0; i < count; ++i, seconds += 0.5 / 24.0)
        input.receive(clock_tick, device, seconds);
    return seconds;
}
}  // namespace

TEST_CASE("only real-time bytes and song positions belong to the clock") {
    for (const unsigned char first : std::array<unsigned char, 5>{0xF2, 0xF8, 0xFA, 0xFB, 0xFC})
        CHECK(MidiClockInput::is_clock_message(std::array<unsigned char, 1>{first}));
    CHECK_FALSE(MidiClockInput::is_clock_message(std::array<unsigned char, 3>{0xB0, 7, 64}));
    CHECK_FALSE(MidiClockInput::is_clock_message({}));
}

TEST_CASE("the clocks of two devices are not mixed, and the other takes over when one ends") {
    MidiClockInput input;
    const double later = run(input, 0, 48, 0.0);
    run(input, 1, 48, 0.01);
    CHECK(*input.clock().bpm() == doctest::Approx(120.0));
    CHECK(input.clock().is_present(later));
    run(input, 1, 24, later + 1.0);
    CHECK(*input.clock().bpm() == doctest::Approx(120.0));
    CHECK(input.clock().is_present(later + 1.5));
}
