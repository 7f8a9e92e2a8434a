// Bytes of other programs and devices: OSC packets, MIDI messages, the beam as text and as samples.

#include "fuzz/fuzz_files.h"
#include "io/control/osc_packet.h"
#include "model/devices/midi.h"
#include "model/devices/midi_trigger.h"
#include "signals/beam/beam_input_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace {
// In chunks of 1, 2, 3, ... bytes, as a pipe can deliver them.
void check_beam(std::string_view bytes, bool is_raw) {
    BeamInputReader reader({.is_raw = is_raw}, "beam");
    std::vector<BeamInputPoint> points;
    for (std::size_t length = 1; !bytes.empty(); ++length) {
        const std::string_view chunk = bytes.substr(0, std::min(length, bytes.size()));
        reader.take(chunk, points);
        bytes.remove_prefix(chunk.size());
    }
    reader.finish(points);
    for (const BeamInputPoint& point : points)
        require(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.current) &&
                    point.seconds >= 0.0,
                "a point has finite numbers");
    require((reader.bad_count() > 0) == reader.problem().has_value(), "errors are reported");
}
}  // namespace

void fuzz_one(std::string_view input) {
    if (input.empty())
        return;
    const std::string_view rest = input.substr(1);
    const std::span<const std::uint8_t> bytes(reinterpret_cast<const std::uint8_t*>(rest.data()),
                                              rest.size());
    switch (input.front()) {
        case 'm':
            static_cast<void>(parse_midi(bytes));
            static_cast<void>(parse_midi_press(bytes));
            return;
        case 't':
            return check_beam(rest, false);
        case 'r':
            return check_beam(rest, true);
        default:
            if (const auto messages = parse_osc(bytes); !messages)
                require_messages(messages.error());
    }
}
