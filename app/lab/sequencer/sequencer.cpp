#include "lab/sequencer/sequencer.h"

void Sequencer::update(double wall_seconds) {
    m_overview.follow(m_work.player.signal().sound().sound);
    m_overview.update();
    m_scrubber.update();
    update_tempo();
    m_playlist.update(m_tempo.tempo(), wall_seconds);
    m_cues.update();
}

void Sequencer::update_tempo() {
    const MidiControl& midi = m_remote.midi();
    const MidiClockInput* input = midi.is_listening() ? midi.clock() : nullptr;
    const auto clock = input ? std::optional(input->clock()) : std::nullopt;
    m_tempo.update(clock ? &*clock : nullptr, MidiClockInput::now());
}
