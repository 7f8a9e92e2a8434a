#pragma once

#include "lab/frame/workspace.h"
#include "lab/remote/remote_control.h"
#include "lab/sequencer/cue_control.h"
#include "lab/sequencer/playlist_control.h"
#include "lab/sequencer/scrubber.h"
#include "lab/sequencer/sound_overview.h"
#include "lab/sequencer/tempo_control.h"

/// The timeline of the window: waveform of the sound, scrubbing, tempo, playlist and cues.
class Sequencer {
public:
    /// `remote` provides the MIDI clock.
    Sequencer(Workspace& work, FrameLoop& frames, PresetNavigation& presets,
              const RemoteControl& remote)
        : m_work(work), m_remote(remote), m_playlist(work, presets), m_cues(work, frames) {}

    const SoundOverview& overview() const { return m_overview; }
    Scrubber& scrubber() { return m_scrubber; }
    const Scrubber& scrubber() const { return m_scrubber; }

    TempoControl& tempo() { return m_tempo; }
    const TempoControl& tempo() const { return m_tempo; }
    PlaylistControl& playlist() { return m_playlist; }
    const PlaylistControl& playlist() const { return m_playlist; }
    CueControl& cues() { return m_cues; }
    const CueControl& cues() const { return m_cues; }

    /// The open document with the values of its cues at the present position.
    Document drawn_document() const;

    /// Tempo and cues that the first document gets, from the session.
    void set_initial(const Tempo& tempo, const CueText& cues) {
        m_initial_tempo = tempo;
        m_initial_cues = cues;
    }
    const Tempo& initial_tempo() const { return m_initial_tempo; }
    const CueText& initial_cues() const { return m_initial_cues; }

    /// Call once per update, before the frame is drawn.
    void update(double wall_seconds);
    /// Whether the next update has work without any event.
    bool is_busy() const {
        return m_overview.is_measuring() || m_scrubber.is_busy() || m_playlist.is_playing();
    }

private:
    void update_tempo();

    Workspace& m_work;
    const RemoteControl& m_remote;
    SoundOverview m_overview;
    Scrubber m_scrubber{m_work};
    TempoControl m_tempo{m_work};
    PlaylistControl m_playlist;
    CueControl m_cues;
    Tempo m_initial_tempo;
    CueText m_initial_cues;
};
