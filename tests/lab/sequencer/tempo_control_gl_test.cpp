#include "lab/sequencer/tempo_control.h"
#include "lab/small_lab.h"

namespace {
double beat_now(SmallLab& small, const TempoControl& control) {
    return control.tempo().beats_at(small.player().transport().time());
}
}  // namespace

TEST_CASE("a typed tempo continues the beat, and undo restores the former one") {
    SmallLab small;
    TempoControl control(small.lab().work());
    small.player().pause();
    small.player().seek(3.3);
    const double before = beat_now(small, control);
    control.set_bpm(87.5);
    CHECK(small.document().state().tempo.bpm == 87.5);
    CHECK(beat_now(small, control) == doctest::Approx(before));
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(small.document().state().tempo == Tempo{});
}

TEST_CASE("taps set the tempo and put a beat on the tap, as one undo step") {
    SmallLab small;
    TempoControl control(small.lab().work());
    small.player().pause();
    for (int i = 0; i < 5; ++i) {
        small.player().seek(1.13 + 0.4 * i);
        control.tap(100.0 + 0.4 * i);
    }
    CHECK(small.document().state().tempo.bpm == doctest::Approx(150.0));
    const double beat = beat_now(small, control);
    CHECK(std::abs(beat - std::round(beat)) < 1e-6);
    control.update(nullptr, 110.0);
    CHECK_FALSE(small.document().history().is_in_gesture());
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(small.document().state().tempo == Tempo{});
}

TEST_CASE("a MIDI clock is the tempo while it is present, and the beat continues after it") {
    SmallLab small;
    TempoControl control(small.lab().work());
    small.player().pause();
    small.player().seek(7.0);
    MidiClock clock;
    double now = 50.0;
    clock.take(0xFA, now);
    for (int i = 0; i < 48; ++i, now += 60.0 / 96.0 / 24.0)
        clock.take(0xF8, now);
    control.update(&clock, now);
    CHECK(control.follows_midi());
    CHECK(control.tempo().bpm == doctest::Approx(96.0));
    CHECK(beat_now(small, control) == doctest::Approx(2.0));
    CHECK(small.document().state().tempo == Tempo{});
    control.update(&clock, now + 1.0);
    CHECK_FALSE(control.follows_midi());
    CHECK(control.tempo().bpm == doctest::Approx(96.0));
    CHECK(beat_now(small, control) == doctest::Approx(2.0));
}
