#pragma once

#include "io/control/midi_inputs.h"
#include "lab/remote/midi_triggers.h"
#include "lab/remote/remote_edits.h"
#include "model/devices/remote_settings.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What the messages of an update learnt, and the commands that they run.
struct MidiUpdate {
    std::optional<MidiBinding> learnt = {};
    std::optional<MidiCommand> learnt_command = {};
    std::vector<PressedCommand> pressed = {};
};

/// Controls parameters and commands by MIDI devices, and learns their mapping.
class MidiControl {
public:
    explicit MidiControl(std::unique_ptr<MidiInputs> inputs) : m_inputs(std::move(inputs)) {}

    /// Opens all current devices, or closes them. If it fails, none is open.
    Result<void> listen(bool listens);
    bool is_listening() const { return m_is_listening; }
    std::vector<std::string> devices() const { return m_inputs->names(); }
    /// Becomes readable when messages are available; never changes.
    int descriptor() const { return m_inputs->descriptor(); }
    /// The clock of the devices; null: not supported.
    const MidiClockInput* clock() const { return m_inputs->clock(); }

    /// Binds the next moved controller to `goal`; nullopt: stops learning.
    void learn(std::optional<MidiTarget> goal);
    const std::optional<MidiTarget>& learning() const { return m_goal; }
    /// Binds the next pressed note, program or button to a command; nullopt: stops learning.
    void learn_command(std::optional<std::string> command);
    const std::optional<std::string>& learning_command() const { return m_triggers.learning(); }

    /// Applies the received messages; `document` null: no look is open.
    MidiUpdate update(const RemoteSettings& settings, Document* document, RemoteEdits& edits,
                      double now_seconds);

    /// The last received message, bound or not: "CC 21, channel 1, value 64"; "": none.
    const std::string& last() const { return m_last; }
    /// The number of applied and refused changes, and the last reason for refusal; "": not refused.
    std::size_t applied() const { return m_applied; }
    std::size_t refused() const { return m_refused; }
    const std::string& problem() const { return m_problem; }

private:
    void take(std::span<const std::uint8_t> message, const RemoteSettings& settings,
              Document* document, RemoteEdits& edits, double now_seconds, MidiUpdate& news);
    std::optional<MidiBinding> learnt_of(const MidiControlChange& change, double now_seconds);
    void set_value(const MidiBinding& binding, double share, const RemoteSettings& settings,
                   Document& document, RemoteEdits& edits, double now_seconds);

    std::unique_ptr<MidiInputs> m_inputs;
    bool m_is_listening = false;
    std::optional<MidiTarget> m_goal;
    std::optional<MidiBinding> m_learnt;  // can become a 14-bit binding
    double m_learnt_seconds = 0.0;
    Midi14BitDecoder m_pairs;
    std::map<std::pair<std::string, std::size_t>, SoftTakeover> m_takeovers;  // by target
    MidiTriggers m_triggers;
    std::string m_last;
    std::size_t m_applied = 0;
    std::size_t m_refused = 0;
    std::string m_problem;
};

/// The bindings that control a parameter of a look.
std::vector<MidiBinding> bindings_of(const Parameter& parameter, const Look& look,
                                     const RemoteSettings& settings);
