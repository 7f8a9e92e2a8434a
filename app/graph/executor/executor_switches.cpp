// The part of Executor for passes that the user has switched: frozen, left out, bypassed.
#include "graph/executor/executor.h"

#include <algorithm>

Result<void> Executor::set_displayed(std::vector<bool> seen, Frames frames) {
    const gpu::ContextScope scope(m_home.get());
    std::swap(m_displayed, seen);
    std::swap(m_frames, frames);
    auto planned = plan_again();
    if (!planned) {
        std::swap(m_displayed, seen);
        std::swap(m_frames, frames);
    }
    return planned;
}

PlanTerms Executor::plan_terms() const {
    PlanTerms terms{.largest_side = m_largest_side,
                    .seen = m_displayed,
                    .draws_once = m_frames == Frames::drawn_once};
    if (!terms.seen.empty())
        terms.seen.resize(m_passes.size(), true);
    for (std::size_t i = 0; i < m_passes.size(); ++i) {
        terms.kept.push_back(run_of(i) != PassRun::drawn);
        terms.left_out.push_back(run_of(i) == PassRun::left_out);
        terms.read.emplace_back();
        for (const Input& input : m_look.passes[i].inputs)
            terms.read.back().push_back(
                std::ranges::find(m_passes[i].inputs, input.uniform, &BoundInput::uniform) !=
                m_passes[i].inputs.end());
    }
    return terms;
}

Result<void> Executor::set_runs(std::vector<PassRun> runs) {
    const gpu::ContextScope scope(m_home.get());
    if (!m_pass_through && std::ranges::find(runs, PassRun::bypassed) != runs.end()) {
        auto made = PassThrough::make();
        if (!made)
            return fail(made.error());
        m_pass_through.emplace(std::move(*made));
    }
    drop_frame();
    std::vector<bool> changed(m_passes.size(), false);
    for (std::size_t i = 0; i < changed.size(); ++i)
        changed[i] = run_of(i) != (i < runs.size() ? runs[i] : PassRun::drawn);
    std::swap(m_runs, runs);
    if (auto planned = plan_again(); !planned) {
        std::swap(m_runs, runs);
        return planned;
    }
    restart_samples(changed);
    return {};
}

PassRun Executor::run_of(std::size_t pass) const {
    return pass < m_runs.size() ? m_runs[pass] : PassRun::drawn;
}

bool Executor::is_kept(std::size_t pass) const {
    const PassRun run = run_of(pass);
    return run == PassRun::left_out || (run == PassRun::frozen && m_targets[pass].is_drawn());
}

std::vector<bool> Executor::read_for(const std::vector<bool>& seen) const {
    std::vector<bool> read(m_passes.size(), false);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < std::min(seen.size(), read.size()); ++i)
        if (seen[i])
            open.push_back(i);
    while (!open.empty()) {
        const std::size_t pass = open.back();
        open.pop_back();
        if (read[pass])
            continue;
        read[pass] = true;
        for (std::size_t guest = 0; guest < m_plan.targets.size(); ++guest)
            if (m_plan.targets[guest].onto == pass)
                open.push_back(guest);
        for (const BoundInput& input : m_passes[pass].inputs)
            if (input.from == Input::From::pass && input.pass >= 0)
                open.push_back(static_cast<std::size_t>(input.pass));
    }
    return read;
}

double Executor::bytes_per_pixel() const {
    const auto bytes_of = [this](std::size_t pass) {
        const PlannedTarget& target = m_plan.targets[pass];
        if (target.onto)
            return 0.0;
        return static_cast<double>(target.extent.width) * target.extent.height *
               facts_of(target.format).bytes;
    };
    double bytes = 0.0;
    for (std::size_t i = 0; i < m_passes.size(); ++i) {
        if (is_kept(i))
            continue;
        bytes += bytes_of(i);
        for (const BoundInput& input : m_passes[i].inputs)
            if (input.from == Input::From::pass && input.pass >= 0)
                bytes += bytes_of(static_cast<std::size_t>(input.pass));
    }
    const Extent picture = m_plan.targets.back().extent;
    return bytes / (static_cast<double>(picture.width) * picture.height);
}

void Executor::clear_history(int pass) {
    if (static_cast<std::size_t>(pass) >= m_targets.size())
        return;  // nothing has been drawn yet
    const gpu::ContextScope scope(m_home.get());
    drop_frame();
    ++m_picture_number;
    m_targets[static_cast<std::size_t>(pass)].clear();
    std::vector<bool> changed(m_passes.size(), false);
    changed[static_cast<std::size_t>(pass)] = true;
    restart_samples(changed);
}

void Executor::pass_through(std::size_t index) {
    const Pass& pass = m_look.passes[index];
    const BoundInput input = bound_input(m_look, static_cast<int>(index), *passed_input(pass));
    const gpu::Texture* from = texture_for(input);
    Target& target = m_targets[index];
    m_passes[index].timer->begin();
    m_pass_through->draw(from ? *from : m_empty.at(SampleKind::floating).texture(), input.sampler,
                         target.canvas(), m_samplers, rows_of(input) != pass.rows);
    m_passes[index].timer->end();
    target.canvas().texture().generate_mipmaps();
}

// Whether it would draw the same picture again while its inputs of this frame do not change.
bool Executor::rests(std::size_t index) const {
    const Pass& pass = m_look.passes[index];
    if (is_kept(index))
        return true;
    if (run_of(index) == PassRun::bypassed)
        return passed_input(pass)->frames_ago == 0;
    if (pass.accumulate)
        return enough_of(pass).value_or(0) > 0 && m_passes[index].samples >= *enough_of(pass);
    const bool reads_what_moves = std::ranges::any_of(pass.inputs, [](const Input& input) {
        return input.frames_ago > 0 || input.from == Input::From::sound ||
               input.from == Input::From::keyboard;
    });
    return !reads_what_moves && !m_passes[index].built_ins.tell_time();
}
