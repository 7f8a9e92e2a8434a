#pragma once

#include "io/control/midi_inputs.h"
#include "lab/remote/remote_hand.h"
#include "model/devices/remote_settings.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Lets the knobs of MIDI devices turn parameters, and learns which of them turns what.
class MidiControl {
public:
    explicit MidiControl(std::unique_ptr<MidiInputs> inputs) : m_inputs(std::move(inputs)) {}

    /// Listens to the devices that there are now, or to none. On failure it does not listen.
    Result<void> listen(bool listens);
    bool is_listening() const { return m_is_listening; }
    std::vector<std::string> devices() const { return m_inputs->names(); }
    /// Becomes readable when a message has come; always the same.
    int descriptor() const { return m_inputs->descriptor(); }

    /// The next controller that is turned is to be bound to it; none: nothing more is learnt.
    void learn(std::optional<MidiGoal> goal);
    const std::optional<MidiGoal>& learning() const { return m_goal; }

    /// Takes in what has come; null: nothing is open to be turned. Gives what was learnt by it.
    std::optional<MidiBinding> update(const RemoteSettings& settings, Document* document,
                                      RemoteHand& hand, double now_seconds);

    /// The one that was turned last, bound or not.
    const std::optional<MidiTurn>& last() const { return m_last; }
    /// How many turned something, or were refused, and why the last one was; "" for none.
    std::size_t turned() const { return m_turned; }
    std::size_t refused() const { return m_refused; }
    const std::string& problem() const { return m_problem; }

private:
    std::optional<MidiBinding> learnt_of(const MidiTurn& turn, double now_seconds);
    void turn(const MidiBinding& binding, double share, const RemoteSettings& settings,
              Document& document, RemoteHand& hand, double now_seconds);

    std::unique_ptr<MidiInputs> m_inputs;
    bool m_is_listening = false;
    std::optional<MidiGoal> m_goal;
    std::optional<MidiBinding> m_learnt;  // which may turn out to be fine
    double m_learnt_seconds = 0.0;
    MidiPairs m_pairs;
    std::map<std::pair<std::string, std::size_t>, PickUp> m_pick_ups;  // by goal
    std::optional<MidiTurn> m_last;
    std::size_t m_turned = 0;
    std::size_t m_refused = 0;
    std::string m_problem;
};

/// Those that turn a parameter of a look.
std::vector<MidiBinding> bindings_of(const Parameter& parameter, const Look& look,
                                     const RemoteSettings& settings);
