#pragma once

#include "io/control/midi_inputs.h"
#include "lab/remote/remote_edits.h"
#include "model/devices/remote_settings.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Controls parameters by MIDI devices, and learns their mapping.
class MidiControl {
public:
    explicit MidiControl(std::unique_ptr<MidiInputs> inputs) : m_inputs(std::move(inputs)) {}

    /// Opens all current devices, or closes them. If it fails, none is open.
    Result<void> listen(bool listens);
    bool is_listening() const { return m_is_listening; }
    std::vector<std::string> devices() const { return m_inputs->names(); }
    /// Becomes readable when messages are available; never changes.
    int descriptor() const { return m_inputs->descriptor(); }

    /// Binds the next moved controller to `goal`; nullopt: stops learning.
    void learn(std::optional<MidiTarget> goal);
    const std::optional<MidiTarget>& learning() const { return m_goal; }

    /// Applies the received messages; `document` null: no look is open. Returns a learnt binding.
    std::optional<MidiBinding> update(const RemoteSettings& settings, Document* document,
                                      RemoteEdits& edits, double now_seconds);

    /// The last received controller value, bound or not.
    const std::optional<MidiControlChange>& last() const { return m_last; }
    /// The number of applied and refused changes, and the last reason for refusal; "": not refused.
    std::size_t applied() const { return m_applied; }
    std::size_t refused() const { return m_refused; }
    const std::string& problem() const { return m_problem; }

private:
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
    std::optional<MidiControlChange> m_last;
    std::size_t m_applied = 0;
    std::size_t m_refused = 0;
    std::string m_problem;
};

/// The bindings that control a parameter of a look.
std::vector<MidiBinding> bindings_of(const Parameter& parameter, const Look& look,
                                     const RemoteSettings& settings);
