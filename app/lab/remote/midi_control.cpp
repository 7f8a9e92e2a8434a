#include "lab/remote/midi_control.h"

#include "lab/document/naming.h"
#include "model/tuning/slider_share.h"

#include <fmt/format.h>

Result<void> MidiControl::listen(bool listens) {
    m_inputs->close();
    m_is_listening = false;
    learn({});
    m_last.clear();
    m_takeovers.clear();
    m_triggers = {};
    m_problem.clear();
    m_applied = m_refused = 0;
    if (!listens)
        return {};
    auto opened = m_inputs->open();
    m_is_listening = opened.has_value();
    return opened;
}

void MidiControl::learn(std::optional<MidiTarget> goal) {
    m_goal = std::move(goal);
    m_learnt.reset();
    m_triggers.learn({});
}

void MidiControl::learn_command(std::optional<std::string> command) {
    learn({});
    m_triggers.learn(std::move(command));
}

// A 14-bit device sends the lower half immediately after the upper one. Then both are bound.
std::optional<MidiBinding> MidiControl::learnt_of(const MidiControlChange& change,
                                                  double now_seconds) {
    constexpr double right_behind = 0.05;  // s
    if (m_goal) {
        m_learnt = MidiBinding{*std::exchange(m_goal, {}), change.channel, change.controller};
        m_learnt_seconds = now_seconds;
        return m_learnt;
    }
    auto previous = std::exchange(m_learnt, {});
    if (!previous || !is_lower_half(change, *previous) ||
        now_seconds - m_learnt_seconds > right_behind)
        return std::nullopt;
    previous->is_fine = true;
    return previous;
}

MidiUpdate MidiControl::update(const RemoteSettings& settings, Document* document,
                               RemoteEdits& edits, double now_seconds) {
    MidiUpdate news;
    constexpr int maximum = 1000;  // per update, so that endless input cannot block the picture
    for (int i = 0; i < maximum; ++i) {
        const auto message = m_inputs->take();
        if (!message)
            break;
        take(*message, settings, document, edits, now_seconds, news);
    }
    if (news.learnt)
        m_takeovers.erase({news.learnt->goal.parameter, news.learnt->goal.component});
    return news;
}

void MidiControl::take(std::span<const std::uint8_t> message, const RemoteSettings& settings,
                       Document* document, RemoteEdits& edits, double now_seconds,
                       MidiUpdate& news) {
    const auto press = parse_midi_press(message);
    const auto change = parse_midi(message);
    if (press)
        m_last = change ? fmt::format("{}, value {}", to_string(press->trigger), change->value)
                        : fmt::format("{}{}", to_string(press->trigger),
                                      press->is_down ? "" : ", released");
    if (!m_goal)
        if (auto command = m_triggers.take(message, settings, news.pressed)) {
            news.learnt_command = std::move(command);
            return;
        }
    if (!change)
        return;
    if (auto learnt = learnt_of(*change, now_seconds))
        news.learnt = learnt;
    else if (document && !document->has_pending_stack())
        for (const MidiBinding& binding : settings.midi)
            if (const auto share = m_pairs.share(binding, *change))
                set_value(binding, *share, settings, *document, edits, now_seconds);
    m_pairs.note(*change);
}

// A parameter that the open look does not have belongs to another look and is ignored.
void MidiControl::set_value(const MidiBinding& binding, double share,
                            const RemoteSettings& settings, Document& document, RemoteEdits& edits,
                            double now_seconds) {
    const auto meant = resolve_parameter(binding.goal.parameter, document.look());
    if (!meant || !has_slider_numbers(**meant))
        return;
    const Parameter& parameter = **meant;
    const SliderNumber number{parameter, setting_of(parameter.name, document.parameter_settings()),
                              binding.goal.component};
    SoftTakeover& takeover = m_takeovers[{binding.goal.parameter, binding.goal.component}];
    const double current = share_at(number, document.value(parameter));
    const bool accepts = takeover.accepts(share, current);
    if (settings.has_soft_takeover && is_gradual(parameter) && !accepts)
        return;
    const auto done = edits.apply(
        document, {parameter.name, value_at_share(number, document.value(parameter), share)},
        now_seconds);
    if (!done) {
        ++m_refused;
        m_problem = done.error().front().message;
        return;
    }
    ++m_applied;
    takeover.record(share_at(number, document.value(parameter)));
}

std::vector<MidiBinding> bindings_of(const Parameter& parameter, const Look& look,
                                     const RemoteSettings& settings) {
    std::vector<MidiBinding> found;
    for (const MidiBinding& binding : settings.midi)
        if (const auto meant = resolve_parameter(binding.goal.parameter, look);
            meant && (*meant)->name == parameter.name)
            found.push_back(binding);
    return found;
}
