#include "lab/previews/step_probe.h"

#include "gpu/objects/readback.h"
#include "graph/inspect/texel_programs.h"
#include "lab/document/changes.h"
#include "model/tuning/one_step.h"
#include "model/tuning/parameter_settings.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

void StepProbe::ask(const StepRequest& request) {
    if (m_request == request)
        return;
    stop();
    m_request = request;
}

void StepProbe::stop() {
    m_request.reset();
    m_trial.reset();
    m_picture.reset();
    m_has_picture = false;
    m_changes.clear();
    m_effect.reset();
    m_is_answered = false;
    m_has_failed = false;
    m_text.clear();
}

void StepProbe::fail_with(std::string text) {
    m_trial.reset();
    m_is_answered = true;
    m_has_failed = true;
    m_text = std::move(text);
}

bool StepProbe::make_tools() {
    if (m_tools)
        return true;
    auto meter = PairMeter::make();
    auto difference = SignedDifference::make();
    if (!meter || !difference)
        return false;
    m_tools.emplace(Tools{std::move(*meter), std::move(*difference)});
    return true;
}

// The step is from the stored value, even if the parameter is modulated.
void StepProbe::begin(const PreviewSubject& subject) {
    const Document& document = subject.document;
    const Look& look = document.look();
    m_values = document.values();
    m_extent = subject.picture;
    m_is_answered = false;
    m_has_failed = false;
    m_effect.reset();
    m_changes.assign(look.passes.size(), std::nullopt);
    m_next = 0;
    const Parameter* declared = find_parameter(look, m_request->parameter);
    if (!declared)
        return fail_with("This parameter no longer exists");
    const Parameter parameter =
        with_ends(*declared, setting_of(declared->name, document.parameter_settings()));
    const auto next =
        one_step(parameter, value_of(parameter, m_values), m_request->component, m_request->is_up);
    if (!next)
        return fail_with(next.error().front().message);
    if (parameter.is_constant)
        return fail_with(preview_error(parameter));
    Values others = m_values;
    others[parameter.name] = *next;
    DocumentState before = document.state();
    DocumentState after = before;
    before.values = m_values;
    after.values = others;
    m_change = line_of(changes_between(look, before, after).front());
    m_text = fmt::format("{} …", m_change);
    constexpr double sample_budget_seconds = 1.0;
    constexpr double times = 2.0;
    const std::size_t frames = affordable_frames(look, subject.shown, sample_budget_seconds, times);
    auto trial = PreviewRenderer::make(subject, m_values, &others, frames);
    if (!trial)
        return fail_with(trial.error().front().message);
    if (!make_tools())
        return fail_with("Not enough memory to compare the pictures");
    m_trial.emplace(std::move(*trial));
}

Pair StepProbe::pair_of(std::size_t pass) const {
    const int index = static_cast<int>(pass);
    return {m_trial->executor().target(index), m_trial->others()->target(index),
            encoding_of(m_trial->executor().look(), index)};
}

namespace {
// For targets that the GPU cannot compare: integer formats, or different sizes.
PassChange compared_alone(const Pair& pair) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const auto apart =
        difference_between(gpu::read_picture(pair.ours), gpu::read_picture(pair.other), 0.0);
    return apart ? PassChange{apart->mean, apart->largest, 1.0}
                 : PassChange{infinite, infinite, 0.0};
}
}  // namespace

// One pass after the other, without waiting for the GPU.
void StepProbe::measure() {
    if (const auto measured = m_tools->meter.take(); measured && measured->change)
        m_changes[m_next++] = *measured->change;
    while (m_next < m_changes.size() && !m_tools->meter.is_busy()) {
        const Pair pair = pair_of(m_next);
        if (are_comparable(pair.ours, pair.other))
            m_tools->meter.start_change(pair, m_next + 1 == m_changes.size());
        if (!m_tools->meter.is_busy())
            m_changes[m_next++] = compared_alone(pair);
    }
    if (m_next == m_changes.size())
        conclude();
}

void StepProbe::draw_difference() {
    const Pair pair = pair_of(m_changes.size() - 1);
    m_has_picture =
        are_comparable(pair.ours, pair.other) && fit_floats(m_picture, pair.ours.extent());
    if (m_has_picture)
        m_tools->difference.draw(pair, m_gain, *m_picture);
}

void StepProbe::conclude() {
    const Look& look = m_trial->executor().look();
    std::vector<PassChange> changes;
    for (const auto& change : m_changes)
        changes.push_back(*change);
    m_effect = effect_of(look, *find_parameter(look, m_request->parameter), changes);
    m_gain = gain_for(changes.back().largest);
    draw_difference();
    const std::string effect = effect_text(*m_effect, changes.back());
    m_text = m_has_picture && changes.back().has_changed() && m_gain > 1.0
                 ? fmt::format("{}: {} · amplified {:.0f}×", m_change, effect, m_gain)
                 : fmt::format("{}: {}", m_change, effect);
    m_trial.reset();
    m_is_answered = true;
}

void StepProbe::update(const PreviewSubject& subject, double slice_seconds) {
    if (!m_request || subject.player.transport().past().empty())
        return;
    const bool is_other = m_values != subject.document.values() || m_extent != subject.picture;
    const bool is_new = !m_trial && !m_is_answered;
    if (is_new || is_other)
        begin(subject);
    if (!m_trial)
        return;
    if (m_trial->is_running()) {
        m_trial->update(subject, slice_seconds);
        const std::size_t share = 100 * m_trial->done() / m_trial->total();
        m_text = fmt::format("{}: rendering, {} %", m_change, share);
        return;
    }
    measure();
}
