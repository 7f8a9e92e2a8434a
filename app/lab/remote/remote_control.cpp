#include "lab/remote/remote_control.h"

#include "lab/storage/remote_store.h"
#include "model/tuning/slider_share.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

RemoteControl::RemoteControl(OpenDocument& document, const Roots& roots, Messages& messages,
                             std::unique_ptr<MidiInputs> midi)
    : m_document(document), m_roots(roots), m_messages(messages), m_midi(std::move(midi)) {
    const auto settings = load_remote_settings(m_roots);
    if (!m_messages.succeeded(settings))
        return;
    m_settings = *settings;
    if (m_settings.listens_to_osc)
        m_messages.succeeded(m_osc.listen(m_settings.osc_port));
    if (m_settings.listens_to_midi)
        listen_to_midi(true);
}

void RemoteControl::set_settings(const RemoteSettings& settings) {
    const bool is_other_osc =
        settings.listens_to_osc != m_osc.is_listening() || settings.osc_port != m_settings.osc_port;
    const bool is_other_midi = settings.listens_to_midi != m_midi.is_listening();
    m_settings = settings;
    if (is_other_osc)
        m_messages.succeeded(m_osc.listen(settings.listens_to_osc ? settings.osc_port : 0));
    if (is_other_midi && !listen_to_midi(settings.listens_to_midi))
        m_settings.listens_to_midi = false;
    m_messages.succeeded(save_remote_settings(m_roots, m_settings));
}

// A missing device is not an error: it may be connected later.
bool RemoteControl::listen_to_midi(bool listens) {
    const auto done = m_midi.listen(listens);
    if (!done)
        m_messages.say(fmt::format("MIDI: {}", done.error().front().message));
    return done.has_value();
}

void RemoteControl::find_midi_devices() {
    if (!listen_to_midi(true))
        return;
    m_settings.listens_to_midi = true;
    m_messages.say(fmt::format("Listening to MIDI: {}", fmt::join(m_midi.devices(), ", ")));
    m_messages.succeeded(save_remote_settings(m_roots, m_settings));
}

void RemoteControl::learn_midi(const MidiTarget& goal) {
    const Parameter* parameter =
        m_document ? find_parameter(m_document->look(), goal.parameter) : nullptr;
    if (!parameter)
        return;
    if (!has_slider_numbers(*parameter))
        return m_messages.say(fmt::format("\"{}\" can't be controlled by MIDI", parameter->label));
    if (!listen_to_midi(true))  // also finds new devices
        return;
    m_settings.listens_to_midi = true;
    m_midi.learn(goal);
}

void RemoteControl::bind_midi(const MidiBinding& binding) {
    m_settings.bind(binding);
    const Parameter* parameter =
        m_document ? find_parameter(m_document->look(), binding.goal.parameter) : nullptr;
    const std::string& name = parameter ? parameter->label : binding.goal.parameter;
    m_messages.say(fmt::format("{} now controls \"{}\"", to_string(binding), name));
    m_messages.succeeded(save_remote_settings(m_roots, m_settings));
}

void RemoteControl::update(double wall_seconds) {
    m_seconds += wall_seconds;
    Document* document = m_document ? &*m_document : nullptr;
    const std::size_t refused_osc = m_osc.refused();
    const std::size_t refused_midi = m_midi.refused();
    m_osc.update(document, m_edits, m_seconds);
    if (const auto learnt = m_midi.update(m_settings, document, m_edits, m_seconds))
        bind_midi(*learnt);
    m_edits.update(document, m_seconds);
    if (m_osc.refused() > refused_osc)
        m_messages.say(fmt::format("OSC: {}", m_osc.problem()), true, "OSC");
    if (m_midi.refused() > refused_midi)
        m_messages.say(fmt::format("MIDI: {}", m_midi.problem()), true, "MIDI");
}
