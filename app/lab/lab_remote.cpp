// The part of Lab that lets other programs and devices turn parameters.
#include "lab/lab.h"
#include "lab/storage/remote_store.h"
#include "model/tuning/knob_turn.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

void Lab::set_remote_settings(const RemoteSettings& settings) {
    const bool is_other_osc =
        settings.listens_to_osc != m_osc.is_listening() || settings.osc_port != m_remote.osc_port;
    const bool is_other_midi = settings.listens_to_midi != m_midi.is_listening();
    m_remote = settings;
    if (is_other_osc)
        succeeded(m_osc.listen(settings.listens_to_osc ? settings.osc_port : 0));
    if (is_other_midi && !listen_to_midi(settings.listens_to_midi))
        m_remote.listens_to_midi = false;
    succeeded(save_remote_settings(m_library.roots(), m_remote));
}

void Lab::open_remote() {
    const auto settings = load_remote_settings(m_library.roots());
    if (!succeeded(settings))
        return;
    m_remote = *settings;
    if (m_remote.listens_to_osc)
        succeeded(m_osc.listen(m_remote.osc_port));
    if (m_remote.listens_to_midi)
        listen_to_midi(true);
}

// A device that is not there is no mistake: it is plugged in later.
bool Lab::listen_to_midi(bool listens) {
    const auto done = m_midi.listen(listens);
    if (!done)
        say(fmt::format("MIDI: {}", done.error().front().message));
    return done.has_value();
}

void Lab::look_for_midi_devices() {
    if (!listen_to_midi(true))
        return;
    m_remote.listens_to_midi = true;
    say(fmt::format("Listening to MIDI: {}", fmt::join(m_midi.devices(), ", ")));
    succeeded(save_remote_settings(m_library.roots(), m_remote));
}

void Lab::learn_midi(const MidiGoal& goal) {
    const Parameter* parameter =
        m_document ? find_parameter(m_document->look(), goal.parameter) : nullptr;
    if (!parameter)
        return;
    if (!can_be_turned(*parameter))
        return say(fmt::format("\"{}\" can't be controlled by MIDI", parameter->label));
    if (!listen_to_midi(true))  // also finds what has been plugged in since
        return;
    m_remote.listens_to_midi = true;
    m_midi.learn(goal);
}

void Lab::bind_midi(const MidiBinding& binding) {
    m_remote.bind(binding);
    const Parameter* parameter =
        m_document ? find_parameter(m_document->look(), binding.goal.parameter) : nullptr;
    const std::string& name = parameter ? parameter->label : binding.goal.parameter;
    say(fmt::format("{} now controls \"{}\"", words_of(binding), name));
    succeeded(save_remote_settings(m_library.roots(), m_remote));
}

void Lab::listen(double wall_seconds) {
    m_listened_seconds += wall_seconds;
    Document* document = m_document ? &*m_document : nullptr;
    const std::size_t refused_osc = m_osc.refused();
    const std::size_t refused_midi = m_midi.refused();
    m_osc.update(document, m_hand, m_listened_seconds);
    if (const auto learnt = m_midi.update(m_remote, document, m_hand, m_listened_seconds))
        bind_midi(*learnt);
    m_hand.update(document, m_listened_seconds);
    if (m_osc.refused() > refused_osc)
        say(fmt::format("OSC: {}", m_osc.problem()), true, "OSC");
    if (m_midi.refused() > refused_midi)
        say(fmt::format("MIDI: {}", m_midi.problem()), true, "MIDI");
}
