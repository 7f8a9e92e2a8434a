#pragma once

#include "lab/document/document.h"
#include "lab/messages/messages.h"
#include "lab/remote/midi_control.h"
#include "lab/remote/osc_control.h"
#include "lab/remote/remote_command.h"
#include "lab/remote/remote_log.h"
#include "lab/storage/remote_store.h"
#include "model/devices/remote_settings.h"

#include <deque>
#include <memory>
#include <span>

/// An action of the window that a message asks for. `is_down` is false when the button is released.
struct RequestedAction {
    std::string name;
    bool is_down = true;

    bool operator==(const RequestedAction&) const = default;
};

/// Parameter changes and commands by OSC and MIDI. Changes are edits of the document, with undo.
class RemoteControl {
public:
    /// Opens the devices of the stored settings. `commands` outlives the object.
    RemoteControl(OpenDocument& document, const Roots& roots, Messages& messages,
                  std::unique_ptr<MidiInputs> midi, std::span<const RemoteCommand> commands);

    const OscControl& osc() const { return m_osc; }
    /// See OscControl::set_watch().
    void watch_osc(std::function<void(int descriptor)> watch) { m_osc.set_watch(std::move(watch)); }
    const MidiControl& midi() const { return m_midi; }
    const RemoteLog& log() const { return m_log; }
    void clear_log() { m_log.clear(); }
    const RemoteSettings& settings() const { return m_settings; }
    /// Opens and closes devices, and stores the settings.
    void set_settings(const RemoteSettings& settings);
    /// Finds and opens the MIDI devices; shows a notice with their names.
    void find_midi_devices();
    /// Binds the next controller that moves. Opens the MIDI devices.
    void learn_midi(const MidiTarget& goal);
    /// Binds the next pressed note, program or button. `name` is shown: "Blackout".
    void learn_midi_command(const std::string& command, const std::string& name);
    void end_midi_learning() { m_midi.learn({}); }
    /// The name of the command that is learnt; "": none.
    std::string learning_name() const { return m_midi.learning_command() ? m_learning_name : ""; }

    /// Applies the messages received since the last update, in their order. `parts` are for
    /// commands.
    void update(double wall_seconds, const MutableParts& parts);
    /// Whether the next update has work without any event.
    bool is_busy() const {
        return m_edits.is_in_gesture() || m_osc.has_more() || m_action || !m_pressed.empty();
    }

    /// Asks the window to run an action. Later messages wait until it ran.
    void request_action(RequestedAction action) { m_action = std::move(action); }
    const std::optional<RequestedAction>& requested_action() const { return m_action; }
    /// Reports that the requested action ran, or why not.
    void finish_action(const Result<void>& done);

private:
    /// A message of OSC or MIDI.
    struct Incoming {
        OscMessage message;
        std::string sender = {};
        std::optional<UdpAddress> address = {};  // for replies; nullopt: MIDI
    };

    void save();
    void open_osc();
    bool listen_to_midi(bool listens);
    void bind_midi(const MidiUpdate& news);
    void say_bound(const std::string& trigger, const std::string& name);
    void reject_stale_action(double wall_seconds);
    std::optional<Incoming> next_message();
    int handle(Incoming incoming, const MutableParts& parts);
    Result<OscMessages> answer(const Incoming& incoming, const MutableParts& parts);
    Result<OscMessages> answer_parameter(const Incoming& incoming, const Parameter& parameter);
    void send_replies(const OscMessages& replies, const Incoming& incoming);
    void log(const Incoming& incoming, const Diagnostics& reasons);
    void log_midi();

    OpenDocument& m_document;
    RemoteStore m_store;
    Messages& m_messages;
    std::span<const RemoteCommand> m_commands;
    RemoteSettings m_settings;
    RemoteEdits m_edits;
    OscControl m_osc;
    MidiControl m_midi;
    RemoteLog m_log;
    std::string m_learning_name;
    std::deque<PressedCommand> m_pressed;  // by MIDI, not run yet
    std::optional<RequestedAction> m_action;
    Incoming m_action_message;  // that asked for it
    double m_action_age = 0.0;  // s
    double m_seconds = 0.0;
};
