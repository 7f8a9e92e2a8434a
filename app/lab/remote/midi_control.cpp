#include "lab/remote/midi_control.h"

#include "lab/document/naming.h"
#include "model/tuning/slider_share.h"

Result<void> MidiControl::listen(bool listens) {
    m_inputs->close();
    m_is_listening = false;
    m_goal.reset();
    m_learnt.reset();
    m_takeovers.clear();
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

std::optional<MidiBinding> MidiControl::update(const RemoteSettings& settings, Document* document,
                                               RemoteEdits& edits, double now_seconds) {
    std::optional<MidiBinding> learnt;
    constexpr int maximum = 1000;  // per update, so that endless input cannot block the picture
    for (int i = 0; i < maximum; ++i) {
        const auto message = m_inputs->take();
        if (!message)
            break;
        const auto message_read = parse_midi(*message);
        if (!message_read)
            continue;
        m_last = message_read;
        if (auto now = learnt_of(*message_read, now_seconds))
            learnt = now;
        else if (document && !document->has_pending_stack())
            for (const MidiBinding& binding : settings.midi)
                if (const auto share = m_pairs.share(binding, *message_read))
                    set_value(binding, *share, settings, *document, edits, now_seconds);
        m_pairs.note(*message_read);
    }
    if (learnt)
        m_takeovers.erase({learnt->goal.parameter, learnt->goal.component});
    return learnt;
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
