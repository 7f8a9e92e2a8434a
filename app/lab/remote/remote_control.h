#pragma once

#include "lab/document/document.h"
#include "lab/messages/messages.h"
#include "lab/remote/midi_control.h"
#include "lab/remote/osc_control.h"
#include "lab/storage/roots.h"
#include "model/devices/remote_settings.h"

#include <memory>

/// Parameter changes by OSC and MIDI. They are edits of the document, with undo.
class RemoteControl {
public:
    /// Opens the devices of the stored settings.
    RemoteControl(OpenDocument& document, const Roots& roots, Messages& messages,
                  std::unique_ptr<MidiInputs> midi);

    const OscControl& osc() const { return m_osc; }
    const MidiControl& midi() const { return m_midi; }
    const RemoteSettings& settings() const { return m_settings; }
    /// Opens and closes devices, and stores the settings.
    void set_settings(const RemoteSettings& settings);
    /// Finds and opens the MIDI devices; shows a notice with their names.
    void find_midi_devices();
    /// Binds the next controller that moves. Opens the MIDI devices.
    void learn_midi(const MidiTarget& goal);
    void end_midi_learning() { m_midi.learn({}); }

    /// Applies the messages received since the last update.
    void update(double wall_seconds);
    /// Whether the next update has work without any event.
    bool is_busy() const { return m_edits.is_in_gesture() || m_osc.has_more(); }

private:
    bool listen_to_midi(bool listens);
    void bind_midi(const MidiBinding& binding);

    OpenDocument& m_document;
    const Roots& m_roots;
    Messages& m_messages;
    RemoteSettings m_settings;
    RemoteEdits m_edits;
    OscControl m_osc;
    MidiControl m_midi;
    double m_seconds = 0.0;
};
