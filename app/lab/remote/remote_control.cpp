#include "lab/remote/remote_control.h"

#include "lab/remote/osc_parameters.h"
#include "lab/storage/local_date.h"
#include "lab/storage/remote_store.h"
#include "model/tuning/slider_share.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace {
// Searching for names similar to a long one would take long.
bool is_too_long(const OscMessage& message) {
    constexpr std::size_t longest_address = 256;
    constexpr std::size_t longest_text = 1024;
    return message.address.size() > longest_address ||
           std::ranges::any_of(message.arguments, [](const OscMessage::Argument& argument) {
               const auto* text = std::get_if<std::string>(&argument);
               return text && text->size() > longest_text;
           });
}
}  // namespace

RemoteControl::RemoteControl(OpenDocument& document, const Roots& roots, Messages& messages,
                             std::unique_ptr<MidiInputs> midi,
                             std::span<const RemoteCommand> commands)
    : m_document(document),
      m_store(roots),
      m_messages(messages),
      m_commands(commands),
      m_midi(std::move(midi)) {
    const auto settings = m_store.load();
    if (!m_messages.succeeded(settings))
        return;
    m_settings = *settings;
    if (m_settings.listens_to_osc)
        open_osc();
    if (m_settings.listens_to_midi)
        listen_to_midi(true);
}

void RemoteControl::save() {
    m_messages.succeeded(m_store.save(m_settings));
}

void RemoteControl::open_osc() {
    m_messages.succeeded(
        m_osc.listen(m_settings.listens_to_osc ? m_settings.osc_port : 0, m_settings.osc_reach));
}

void RemoteControl::set_settings(const RemoteSettings& settings) {
    const bool is_other_osc = settings.listens_to_osc != m_osc.is_listening() ||
                              settings.osc_port != m_settings.osc_port ||
                              settings.osc_reach != m_settings.osc_reach;
    const bool is_other_midi = settings.listens_to_midi != m_midi.is_listening();
    m_settings = settings;
    if (is_other_osc)
        open_osc();
    if (is_other_midi && !listen_to_midi(settings.listens_to_midi))
        m_settings.listens_to_midi = false;
    save();
}

// A missing device is not an error: it may be connected later.
bool RemoteControl::listen_to_midi(bool listens) {
    const auto done = m_midi.listen(listens);
    m_pressed.clear();
    if (!done)
        m_messages.say(fmt::format("MIDI: {}", done.error().front().message));
    return done.has_value();
}

void RemoteControl::find_midi_devices() {
    if (!listen_to_midi(true))
        return;
    m_settings.listens_to_midi = true;
    m_messages.say(fmt::format("Listening to MIDI: {}", fmt::join(m_midi.devices(), ", ")));
    save();
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

void RemoteControl::learn_midi_command(const std::string& command, const std::string& name) {
    if (!listen_to_midi(true))
        return;
    m_settings.listens_to_midi = true;
    m_learning_name = name;
    m_midi.learn_command(command);
}

void RemoteControl::bind_midi(const MidiUpdate& news) {
    if (news.learnt) {
        m_settings.bind(*news.learnt);
        const std::string& name = news.learnt->goal.parameter;
        const Parameter* parameter =
            m_document ? find_parameter(m_document->look(), name) : nullptr;
        say_bound(to_string(*news.learnt), parameter ? parameter->label : name);
    }
    if (news.learnt_command) {
        m_settings.bind_command(*news.learnt_command);
        say_bound(to_string(news.learnt_command->trigger), m_learning_name);
    }
}

void RemoteControl::say_bound(const std::string& trigger, const std::string& name) {
    m_messages.say(fmt::format("{} now controls \"{}\"", trigger, name));
    save();
}

void RemoteControl::update(double wall_seconds, const MutableParts& parts) {
    m_seconds += wall_seconds;
    Document* document = m_document ? &*m_document : nullptr;
    const std::size_t refused_midi = m_midi.refused();
    MidiUpdate news = m_midi.update(m_settings, document, m_edits, m_seconds);
    bind_midi(news);
    constexpr std::size_t max_pressed = 100;  // drops presses that would run much later
    for (PressedCommand& pressed : news.pressed)
        if (m_pressed.size() < max_pressed || !pressed.is_down)
            m_pressed.push_back(std::move(pressed));
    if (m_midi.refused() > refused_midi)
        log_midi();
    reject_stale_action(wall_seconds);
    m_osc.begin_update(m_seconds);
    for (int budget = 1000; budget > 0 && !m_action;) {
        auto incoming = next_message();
        if (!incoming)
            break;
        budget -= handle(std::move(*incoming), parts);
    }
    m_edits.update(document, m_seconds);
}

// A hidden window runs no actions. One slow frame does not count as such.
void RemoteControl::reject_stale_action(double wall_seconds) {
    constexpr double timeout = 2.0;  // s
    constexpr double longest_frame = 0.1;
    m_action_age += std::min(wall_seconds, longest_frame);
    if (m_action && m_action_age > timeout)
        finish_action(fail(Diagnostic{{}, 0, "the window is hidden"}));
}

std::optional<RemoteControl::Incoming> RemoteControl::next_message() {
    if (!m_pressed.empty()) {
        const PressedCommand pressed = std::move(m_pressed.front());
        m_pressed.pop_front();
        return Incoming{{fmt::format("{}command/{}", osc_prefix, pressed.command),
                         {pressed.is_down ? 1.0 : 0.0}},
                        "MIDI"};
    }
    std::vector<RejectedPacket> rejected;
    auto received = m_osc.take(rejected);
    for (const RejectedPacket& packet : rejected)
        log({{}, host_text(packet.sender.host)}, {{{}, 0, packet.reason}});
    if (!received)
        return std::nullopt;
    return Incoming{std::move(received->message), host_text(received->sender.host),
                    received->sender};
}

// Returns the cost: commands read folders, replies are packets, and a rejection searches for
// similar names.
int RemoteControl::handle(Incoming incoming, const MutableParts& parts) {
    constexpr int command_cost = 30;
    constexpr int rejection_cost = 10;
    const std::string& address = incoming.message.address;
    const bool is_command = address.starts_with(osc_prefix) &&
                            is_command_address(std::string_view(address).substr(osc_prefix.size()));
    const auto replies = answer(incoming, parts);
    if (m_action) {
        m_action_message = std::move(incoming);
        m_action_age = 0.0;
        return command_cost;
    }
    if (!replies) {
        log(incoming, replies.error());
        return is_command ? command_cost : rejection_cost;
    }
    m_log.accept();
    send_replies(*replies, incoming);
    return static_cast<int>(replies->size()) + (is_command ? command_cost : 1);
}

// A parameter has precedence over a command of the same address.
Result<OscMessages> RemoteControl::answer(const Incoming& incoming, const MutableParts& parts) {
    const OscMessage& message = incoming.message;
    if (!message.address.starts_with(osc_prefix))
        return fail({{}, 0, "the address must start with /afterglow/"});
    if (is_too_long(message))
        return fail({{}, 0, "an address or text is too long"});
    const std::string_view address = std::string_view(message.address).substr(osc_prefix.size());
    const Result<const Parameter*> parameter =
        m_document ? addressed_parameter(address, m_document->look())
                   : fail(Diagnostic{{}, 0, "no look is open"});
    if (parameter)
        return answer_parameter(incoming, **parameter);
    if (is_command_address(address))
        return run_command(message, m_commands, parts);
    const std::string command = fmt::format("command/{}", address);
    for (const RemoteCommand& row : m_commands)
        if (matched_name(row.address, command))
            return fail({{},
                         0,
                         fmt::format("no parameter '{}' (did you mean '{}{}'?)", address,
                                     osc_prefix, command)});
    return fail(parameter.error());
}

// Programs on other machines must not make this one read its files.
Result<OscMessages> RemoteControl::answer_parameter(const Incoming& incoming,
                                                    const Parameter& parameter) {
    const OscMessage& message = incoming.message;
    if (message.arguments.empty() && parameter.control != Control::event)
        return OscMessages{{message.address, arguments_of(m_document->value(parameter))}};
    auto value = value_from_message(message, parameter);
    if (!value)
        return fail(value.error());
    const bool is_file = parameter.control == Control::image || parameter.control == Control::sound;
    if (is_file && incoming.address && !is_local(incoming.address->host, {}))
        return fail({{}, 0, "files can be set only from this machine"});
    const auto done = m_edits.apply(*m_document, {parameter.name, std::move(*value)}, m_seconds);
    if (!done)
        return fail(done.error());
    return OscMessages{};
}

void RemoteControl::send_replies(const OscMessages& replies, const Incoming& incoming) {
    if (!incoming.address)
        return;
    UdpAddress to = *incoming.address;
    if (m_settings.osc_reply_port != 0)
        to.port = m_settings.osc_reply_port;
    for (const OscMessage& reply : replies)
        if (const auto sent = m_osc.send(reply, to); !sent)
            return log(incoming, sent.error());
}

void RemoteControl::finish_action(const Result<void>& done) {
    if (!std::exchange(m_action, {}))
        return;
    if (done)
        m_log.accept();
    else
        log(m_action_message, done.error());
}

void RemoteControl::log(const Incoming& incoming, const Diagnostics& reasons) {
    const std::string& reason = reasons.front().message;
    const bool is_midi = incoming.sender == "MIDI";
    m_log.reject({local_date().seconds, incoming.message.address, arguments_text(incoming.message),
                  incoming.sender, reason});
    const std::string protocol = is_midi ? "MIDI" : "OSC";
    if (m_log.messages().front().count > 1)
        return;  // a notice of each repetition would replace all other notices
    m_messages.say(fmt::format("{}: {}", protocol, m_log.messages().front().reason), true,
                   protocol);
}

// The last refused change of a parameter by a controller.
void RemoteControl::log_midi() {
    log({{m_midi.last(), {}}, "MIDI"}, {{{}, 0, m_midi.problem()}});
}
