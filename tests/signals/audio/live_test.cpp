// Live sound and sound files are drawn by the same code.
#include "signals/audio/audio.h"
#include "signals/signal_making.h"

namespace {
std::shared_ptr<const Sound> three_seconds() {
    return sound_of(
        8000, 24000, [](int i) { return 0.6 * sine_at(97.3, i / 8000.0); },
        [](int i) { return 0.3 * sine_at(211.0, i / 8000.0); });
}
}  // namespace

TEST_CASE("a microphone draws the same as a file with the same samples") {
    const auto sound = three_seconds();
    for (const std::string settings :
         {"mode=xy", "mode=xy,coupling1=ac", "mode=waveform,channel=both,sdiv=0.01",
          "mode=waveform,trigger=normal,trigger_level=0.1,sdiv=0.003", "mode=spectrum",
          "mode=radial"}) {
        INFO(settings);
        const auto file = signal_of("audio:a.wav,loop=off," + settings, sound);
        // The device was opened one second before time 0.
        auto live = std::make_shared<LiveSound>(8000);
        live->write(std::vector<float>(16000, 0.0f), 2);
        const auto made = make_signal(parse_spec("microphone:" + settings).value(),
                                      {.live = live, .live_first = 8000});
        REQUIRE(made.has_value());
        for (std::int64_t frame = 1; frame <= 120; ++frame) {
            // Samples arrive 0.05 s before they are drawn.
            const auto end = static_cast<std::size_t>(frame * 8000 / 60 + 400) * 2;
            const auto have = static_cast<std::size_t>(live->frame_count() - 8000) * 2;
            live->write(std::span(sound->samples).subspan(have, end - have), 2);
            const TimeSpan span = frame_span(frame, 60.0);
            REQUIRE(beam_of(**made, span) == beam_of(*file, span));
        }
    }
}

TEST_CASE("automatic gain of a live sound adjusts to its peak") {
    auto live = std::make_shared<LiveSound>(8000);
    const auto sound = three_seconds();
    live->write(sound->samples, 2);
    const auto made = make_signal(parse_spec("microphone:auto_gain=on").value(), {.live = live});
    float widest = 0.0f;
    for (const BeamPoint& point : beam_of(**made, {1.5, 2.5}))
        widest = std::max(widest, std::abs(point.x));
    CHECK(widest == doctest::Approx(1.0).epsilon(0.01));
}

TEST_CASE("a microphone without a device gives an error with a suggestion") {
    const auto made = make_signal(parse_spec("microphone:mode=xy").value(), {});
    REQUIRE_FALSE(made.has_value());
    CHECK(to_string(made.error()) ==
          "error: microphone: live sound only works in the window. Use audio:FILE for a sound "
          "file.\n");
}
