#include "model/devices/midi_trigger.h"

#include "model/devices/remote_settings.h"

#include <doctest/doctest.h>

#include <array>
#include <vector>

namespace {
using Bytes = std::vector<std::uint8_t>;
using Kind = MidiTrigger::Kind;
}  // namespace

TEST_CASE("notes, programs and controllers of MIDI 1.0 are presses and releases") {
    CHECK(parse_midi_press(Bytes{0x99, 36, 100}) == MidiPress{{Kind::note, 10, 36}, true});
    CHECK(parse_midi_press(Bytes{0x89, 36, 64}) == MidiPress{{Kind::note, 10, 36}, false});
    CHECK(parse_midi_press(Bytes{0x99, 36, 0}) == MidiPress{{Kind::note, 10, 36}, false});
    CHECK(parse_midi_press(Bytes{0xc0, 5}) == MidiPress{{Kind::program, 1, 5}, true});
    CHECK(parse_midi_press(Bytes{0xbf, 64, 64}) == MidiPress{{Kind::control, 16, 64}, true});
    CHECK(parse_midi_press(Bytes{0xbf, 64, 63}) == MidiPress{{Kind::control, 16, 64}, false});
    CHECK(to_string(MidiTrigger{Kind::note, 10, 36}) == "Note 36, channel 10");
    CHECK(to_string(MidiTrigger{Kind::program, 1, 5}) == "Program 5, channel 1");
    CHECK(to_string(MidiTrigger{Kind::control, 16, 64}) == "CC 64, channel 16");
}

TEST_CASE("truncated, overlong and other MIDI messages are no presses") {
    for (const Bytes& bytes :
         {Bytes{}, Bytes{0x90}, Bytes{0x90, 60}, Bytes{0xc0}, Bytes{0xc0, 5, 5}, Bytes{0xc0, 128},
          Bytes{0x90, 200, 1}, Bytes{0x90, 60, 200}, Bytes{0x90, 60, 1, 1}, Bytes{60, 60, 60},
          Bytes{0xe0, 0, 64}, Bytes{0xd0, 5}, Bytes{0xf0, 1, 0xf7}, Bytes{0xf8}, Bytes{0xff}})
        CHECK_FALSE(parse_midi_press(bytes));
    // All messages of up to three bytes from these values, without a crash.
    constexpr std::array<std::uint8_t, 8> values{0, 1, 63, 64, 127, 128, 0xc3, 0xff};
    int presses = 0;
    for (const std::uint8_t first : values)
        for (const std::uint8_t second : values)
            for (const std::uint8_t third : values)
                for (std::size_t size = 0; size <= 3; ++size) {
                    const Bytes all{first, second, third};
                    const auto press = parse_midi_press(std::span(all).first(size));
                    presses += press ? 1 : 0;
                }
    // Program changes of two bytes with a valid number, for each third byte, and note offs (128) of
    // three bytes with two valid ones.
    CHECK(presses == 5 * 8 + 5 * 5);
}

TEST_CASE("a controller is pressed when it reaches the middle, not again above it") {
    MidiPressDetector detector;
    CHECK_FALSE(detector.press(Bytes{0xb0, 20, 10}));
    CHECK(detector.press(Bytes{0xb0, 20, 127})->is_down);
    CHECK_FALSE(detector.press(Bytes{0xb0, 20, 100}));
    CHECK(detector.press(Bytes{0xb1, 20, 127})->is_down);  // of another channel
    CHECK_FALSE(detector.press(Bytes{0xb0, 20, 0})->is_down);
    CHECK_FALSE(detector.press(Bytes{0xb0, 20, 0}));
    CHECK(detector.press(Bytes{0x90, 20, 127})->is_down);
    CHECK(detector.press(Bytes{0x90, 20, 127})->is_down);  // each note is a press
}

TEST_CASE("a command has one trigger, and a trigger may have several commands") {
    RemoteSettings settings;
    settings.bind_command({"action/wipe", {Kind::note, 1, 36}});
    settings.bind_command({"action/undo", {Kind::note, 1, 36}});
    settings.bind_command({"action/wipe", {Kind::program, 1, 2}});
    CHECK(settings.midi_commands ==
          std::vector<MidiCommand>{{"action/undo", {Kind::note, 1, 36}},
                                   {"action/wipe", {Kind::program, 1, 2}}});
    settings.unbind_command("action/undo");
    CHECK(settings.midi_commands.size() == 1);
}
