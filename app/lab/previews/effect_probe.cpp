#include "lab/previews/effect_probe.h"

#include "formats/look_format.h"
#include "model/tuning/trial_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace {
constexpr double min_quiet_seconds = 1.0;
constexpr double slice_seconds = 0.004;
constexpr std::size_t max_answers = 20000;

bool is_probed(const Look& look) {
    return look.stack.empty() ? is_foreign_look(look.manifest)
                              : std::ranges::any_of(look.stack, [](const StackPart& part) {
                                    return is_foreign_look(part.path);
                                });
}

bool is_probed(const Parameter& parameter, const Document& document) {
    return parameter.when.empty() && !parameter.is_constant && !parameter.is_hidden &&
           !trial_values(parameter, document.value(parameter)).empty();
}

// The values of all other parameters decide whether a parameter has an effect.
std::string key_of(const std::string& parameter, const Values& values) {
    std::string key = parameter + ':';
    for (const auto& [name, value] : values)
        if (name != parameter)
            key += fmt::format("{}={};", name, to_string(value));
    return key;
}

// The frames after which the picture no longer depends on earlier ones; 0: too many for a probe.
std::size_t settle_frames(const PreviewSubject& subject) {
    constexpr double budget_seconds = 2.0;
    constexpr double times = 2.0;
    const Look& look = subject.document.look();
    const auto all = static_cast<std::size_t>(std::max(look.settle_frames, 1));
    return affordable_frames(look, subject.shown, budget_seconds, times) < all ? 0 : all;
}
}  // namespace

void EffectProbe::stop() {
    m_trial.reset();
    m_is_look_checked = false;
}

std::optional<bool> EffectProbe::has_effect(const std::string& parameter) const {
    const auto key = m_keys.find(parameter);
    if (key == m_keys.end())
        return std::nullopt;
    const auto found = m_answers.find(key->second);
    return found == m_answers.end() ? std::nullopt : std::optional(found->second);
}

bool EffectProbe::has_other_input(const PreviewSubject& subject) const {
    if (!m_input)
        return true;
    const DocumentState& state = subject.document.state();
    return m_input->state.signal != state.signal || m_input->state.source != state.source ||
           m_input->state.overrides != state.overrides || m_input->picture != subject.picture ||
           (!m_is_look_checked && m_input->look != subject.document.look());
}

void EffectProbe::forget(const PreviewSubject& subject) {
    m_input = Input{subject.document.state(), subject.picture, subject.document.look()};
    m_trial.reset();
    m_answers.clear();
    m_keys.clear();
    m_pending.clear();
}

void EffectProbe::set_values(const PreviewSubject& subject) {
    const Document& document = subject.document;
    m_values = document.values();
    m_quiet_seconds = 0.0;
    m_trial.reset();
    m_trial_values.clear();
    m_keys.clear();
    m_pending.clear();
    // A modulated picture depends on time, so an answer would hold for a moment only.
    if (!is_probed(document.look()) || !document.state().modulations.empty())
        return;
    for (const Parameter& parameter : document.look().parameters) {
        if (!is_probed(parameter, document))
            continue;
        m_keys[parameter.name] = key_of(parameter.name, m_values);
        if (!has_effect(parameter.name))
            m_pending.push_back(parameter.name);
    }
    std::ranges::reverse(m_pending);
}

void EffectProbe::update(const PreviewSubject& subject, bool is_idle, double wall_seconds) {
    const bool is_other = has_other_input(subject);
    if (is_other)
        forget(subject);
    m_is_look_checked = true;
    if (is_other || m_values != subject.document.values() ||
        m_input->state.modulations != subject.document.state().modulations) {
        m_input->state.modulations = subject.document.state().modulations;
        set_values(subject);
    }
    m_quiet_seconds = is_idle ? m_quiet_seconds + wall_seconds : 0.0;
    if (m_quiet_seconds < min_quiet_seconds || m_pending.empty())
        return;
    if (!m_trial)
        begin_parameter(subject);
    else if (m_trial->is_running())
        m_trial->update(subject, slice_seconds);
    else
        measure(subject);
}

void EffectProbe::begin_parameter(const PreviewSubject& subject) {
    const Parameter* parameter = find_parameter(subject.document.look(), m_pending.back());
    const Transport& transport = subject.player.transport();
    m_frames = settle_frames(subject);
    if (transport.past().size() < m_frames && transport.is_playing())
        return;
    if (!parameter || m_frames == 0 || transport.past().size() < m_frames)
        return answer(std::nullopt);
    if (m_trial_values.empty())
        m_trial_values = trial_values(*parameter, subject.document.value(*parameter));
    if (!begin_trial(subject))
        m_pending.clear();  // not enough memory
}

bool EffectProbe::begin_trial(const PreviewSubject& subject) {
    if (!m_meter) {
        auto meter = PairMeter::make();
        if (!meter)
            return false;
        m_meter.emplace(std::move(*meter));
    }
    Values others = m_values;
    others[m_pending.back()] = m_trial_values.back();
    auto trial = PreviewRenderer::make(subject, m_values, &others, m_frames);
    if (!trial)
        return false;
    m_meter->stop();
    m_trial.emplace(std::move(*trial));
    return true;
}

// The picture is compared as displayed. A black picture proves nothing.
void EffectProbe::measure(const PreviewSubject& subject) {
    const auto measured = m_meter->take();
    if (!measured || !measured->change) {
        const int picture = static_cast<int>(m_trial->executor().look().passes.size()) - 1;
        const Pair pair{m_trial->executor().target(picture), m_trial->others()->target(picture),
                        encoding_of(m_trial->executor().look(), picture)};
        if (m_meter->is_busy())
            return;
        if (are_comparable(pair.ours, pair.other))
            m_meter->start_change(pair, true);
        if (!m_meter->is_busy())
            answer(std::nullopt);
        return;
    }
    m_trial.reset();
    m_trial_values.pop_back();
    if (measured->change->has_changed())
        answer(true);
    else if (!(measured->change->level > 0.0))
        answer(std::nullopt);
    else if (m_trial_values.empty())
        answer(false);
    else if (!begin_trial(subject))
        m_pending.clear();
}

void EffectProbe::answer(std::optional<bool> has_effect) {
    if (m_answers.size() >= max_answers)
        m_answers.clear();
    if (has_effect)
        m_answers[m_keys.at(m_pending.back())] = *has_effect;
    m_pending.pop_back();
    m_trial_values.clear();
    m_trial.reset();
}
