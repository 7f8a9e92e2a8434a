#include "lab/sequencer/tempo_control.h"

#include <cmath>
#include <utility>

Tempo TempoControl::tempo() const {
    if (m_work.clock_tempo)
        return *m_work.clock_tempo;
    return m_work.document ? m_work.document->state().tempo : Tempo{};
}

void TempoControl::change(const Tempo& next, const char* step, bool continues_step) {
    if (!m_work.document)
        return;
    if (follows_midi())
        return m_work.messages.say("The MIDI clock sets the tempo. Stop it to set the tempo here.",
                                   true);
    DocumentState state = m_work.document->state();
    state.tempo = normalised(next);
    m_work.document->change(std::move(state), step, continues_step);
}

void TempoControl::set_bpm(double bpm) {
    change(with_bpm(tempo(), bpm, m_work.player.transport().time()), "Set tempo", false);
}

void TempoControl::set_beats_per_bar(double beats) {
    Tempo next = tempo();
    next.beats_per_bar = beats;
    change(next, "Set beats per bar", false);
}

void TempoControl::set_downbeat() {
    change(with_downbeat(tempo(), m_work.player.transport().time()), "Set downbeat", false);
}

void TempoControl::tap(double wall_seconds) {
    m_last_tap = wall_seconds;
    const auto bpm = m_taps.tap(wall_seconds);
    if (!bpm)
        return;
    m_is_tapping = true;
    const double time = m_work.player.transport().time();
    constexpr double resolution = 100.0;  // 0.01 beats per minute
    Tempo next = with_bpm(tempo(), std::round(*bpm * resolution) / resolution, time);
    const double beats = next.beats_at(time);
    next.downbeat += (beats - std::round(beats)) * next.seconds_per_beat();
    change(next, "Tap tempo", true);
}

void TempoControl::update(const MidiClock* clock, double wall_seconds) {
    constexpr double pause = 2.0;  // s, as of TapTempo
    if (m_is_tapping && wall_seconds - m_last_tap > pause) {
        m_is_tapping = false;
        if (m_work.document)
            m_work.document->finish();
    }
    const auto bpm = clock && clock->is_present(wall_seconds) ? clock->bpm() : std::nullopt;
    if (!bpm) {
        // The beat continues when the clock ends.
        if (const auto last = std::exchange(m_work.clock_tempo, std::nullopt);
            last && m_work.document)
            m_work.document->amend([&](DocumentState& state) { state.tempo = *last; });
        return;
    }
    const double time = m_work.player.transport().time();
    Tempo next = with_bpm(tempo(), *bpm, time);
    if (clock->is_running())
        next.downbeat = time - clock->beats_at(wall_seconds) * next.seconds_per_beat();
    m_work.clock_tempo = next;
}
