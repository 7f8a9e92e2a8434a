#pragma once

#include "io/control/midi_clock_input.h"
#include "lab/frame/workspace.h"
#include "model/tuning/tap_tempo.h"

/// The tempo in the window: typed, tapped, or of a MIDI clock. Typed and tapped tempos belong to
/// the document, with undo. A MIDI clock replaces them. When it ends, its last tempo stays.
class TempoControl {
public:
    explicit TempoControl(Workspace& work) : m_work(work) {}

    /// The tempo of the next frame.
    Tempo tempo() const;
    bool follows_midi() const { return m_work.clock_tempo.has_value(); }

    /// The beat continues without a jump.
    void set_bpm(double bpm);
    void set_beats_per_bar(double beats);
    /// A bar begins now.
    void set_downbeat();
    /// A tap at a time that only rises, in seconds: see TapTempo. The nearest beat moves to the
    /// tap. Taps without a pause of two seconds are one undo step.
    void tap(double wall_seconds);

    /// Call it in every update. `clock` null: no MIDI input. Times in seconds as in tap().
    void update(const MidiClock* clock, double wall_seconds);

private:
    void change(const Tempo& next, const char* step, bool continues_step);

    Workspace& m_work;
    TapTempo m_taps;
    double m_last_tap = 0.0;
    bool m_is_tapping = false;
};
