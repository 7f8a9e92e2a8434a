#include "lab/sequencer/sequencer.h"

#include "lab/document/cued_values.h"
#include "lab/playback/sound_position.h"

void Sequencer::update(double wall_seconds) {
    m_overview.follow(m_work.player.signal().sound().sound);
    m_overview.update();
    m_scrubber.update();
    update_tempo();
    m_playlist.update(m_tempo.tempo(), wall_seconds);
    m_cues.update();
}

Document Sequencer::drawn_document() const {
    Document document = *m_work.document;
    const double time = m_work.player.transport().time();
    const auto part = played_part(m_work.player.signal());
    if (m_work.cues)
        apply_cues(document, *m_work.cues, part ? part->position_at(time) : time);
    return document;
}

void Sequencer::update_tempo() {
    const MidiControl& midi = m_remote.midi();
    const MidiClockInput* input = midi.is_listening() ? midi.clock() : nullptr;
    const auto clock = input ? std::optional(input->clock()) : std::nullopt;
    m_tempo.update(clock ? &*clock : nullptr, MidiClockInput::now());
}
