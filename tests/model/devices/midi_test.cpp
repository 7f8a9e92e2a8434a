#include "model/devices/midi.h"

#include "model/devices/remote_settings.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

namespace {
std::optional<MidiControlChange> parsed(std::vector<std::uint8_t> bytes) {
    return parse_midi(bytes);
}

bool is_share(const std::optional<double>& share, double expected) {
    return share && std::abs(*share - expected) <= 1e-12;
}
}  // namespace

TEST_CASE("only a complete Control Change message is parsed") {
    // MIDI 1.0 Detailed Specification, table 2: 1011nnnn 0ccccccc 0vvvvvvv
    CHECK(parsed({0xb0, 21, 64}) == MidiControlChange{1, 21, 64});
    CHECK(parsed({0xbf, 127, 127}) == MidiControlChange{16, 127, 127});
    CHECK_FALSE(parsed({}));
    CHECK_FALSE(parsed({0xb0, 21}));
    CHECK_FALSE(parsed({0xb0, 21, 64, 0}));
    CHECK_FALSE(parsed({0xb0, 0x80, 64}));
    CHECK_FALSE(parsed({0xb0, 21, 0x80}));
    for (const int kind : {0x80, 0x90, 0xa0, 0xc0, 0xd0, 0xe0, 0xf0})
        CHECK_FALSE(parsed({static_cast<std::uint8_t>(kind), 21, 64}));
}

TEST_CASE("a controller maps 0..1 to 127 steps, and a 14-bit pair to 16383") {
    Midi14BitDecoder pairs;
    const MidiBinding plain{{"decay"}, 1, 21};
    CHECK(is_share(pairs.share(plain, {1, 21, 0}), 0.0));
    CHECK(is_share(pairs.share(plain, {1, 21, 127}), 1.0));
    CHECK(is_share(pairs.share(plain, {1, 21, 32}), 32.0 / 127.0));
    CHECK_FALSE(pairs.share(plain, {2, 21, 32}));
    CHECK_FALSE(pairs.share(plain, {1, 22, 32}));
    const MidiBinding fine{{"decay"}, 3, 1, true};
    CHECK_FALSE(pairs.share(fine, {3, 33, 5}));  // the upper half is not known yet
    CHECK_FALSE(pairs.share(fine, {3, 1, 64}));
    pairs.note({3, 1, 64});
    pairs.note({4, 1, 100});  // of another channel
    CHECK(is_share(pairs.share(fine, {3, 33, 5}), 8197.0 / 16383.0));
    pairs.note({3, 1, 127});
    CHECK(is_share(pairs.share(fine, {3, 33, 127}), 1.0));
    CHECK(to_string(plain) == "CC 21, channel 1");
    CHECK(to_string(fine) == "CC 1 and 33, channel 3");
    CHECK(is_lower_half({3, 33, 0}, fine));
    CHECK_FALSE(is_lower_half({3, 34, 0}, fine));
    CHECK_FALSE(is_lower_half({1, 96, 0}, {{"decay"}, 1, 64}));  // controller 64 has no lower half
}

TEST_CASE("soft takeover: a controller takes effect once it passes the value") {
    SoftTakeover takeover;
    CHECK_FALSE(takeover.accepts(0.2, 0.5));
    CHECK_FALSE(takeover.accepts(0.4, 0.5));
    CHECK(takeover.accepts(0.6, 0.5));  // it passes the value
    takeover.record(0.6);
    CHECK(takeover.accepts(0.9, 0.6));  // takes effect at any speed
    takeover.record(0.9);
    CHECK_FALSE(takeover.accepts(0.8, 0.3));  // the value was changed elsewhere
    CHECK_FALSE(takeover.accepts(0.4, 0.3));
    CHECK(takeover.accepts(0.2, 0.3));
    SoftTakeover close;
    CHECK(close.accepts(0.5 + 1.0 / 127.0, 0.5));
    SoftTakeover far;
    CHECK_FALSE(far.accepts(0.5 + 1.5 / 127.0, 0.5));
}

TEST_CASE("a target has one controller, and a controller may have several targets") {
    RemoteSettings settings;
    settings.bind({{"decay"}, 1, 21});
    settings.bind({{"exposure"}, 1, 21});
    settings.bind({{"centre", 1}, 1, 22});
    settings.bind({{"decay"}, 1, 23});
    CHECK(settings.midi == std::vector<MidiBinding>{
                               {{"exposure"}, 1, 21}, {{"centre", 1}, 1, 22}, {{"decay"}, 1, 23}});
    settings.unbind({"centre"});
    CHECK(settings.midi.size() == 3);
    settings.unbind({"centre", 1});
    CHECK(settings.midi.size() == 2);
}
