#include "graph/warm_up/warm_up.h"

#include "gpu/context.h"

WarmUp::~WarmUp() {
    const gpu::ContextScope scope(m_context.get());
    m_draws.clear();
}

void WarmUp::add_draws(const FirstDrawsInput& of) {
    if (!has_new(of.programs, of.known))
        return;
    const gpu::ContextScope scope(m_context.get());
    PassProgram idle;
    if (of.known) {
        auto made = idle_program();
        if (!made)
            return;
        idle = std::move(*made);
    }
    m_draws.push_back(std::make_unique<FirstDraws>(of, idle));
}

void WarmUp::add_views(const Look& look, const Programs& programs, Extent viewport,
                       const Values& values) {
    const auto plan = plan_targets(look, viewport, expected_source, values);
    if (!plan || !programs.first_views)
        return;  // the look itself reports what is wrong with the plan
    m_views = programs.first_views;
    m_views->expect(look, *plan);
}

std::size_t WarmUp::total() const {
    std::size_t total = 0;
    for (const auto& draws : m_draws)
        total += draws->total();
    return total;
}

FirstDraws* WarmUp::unfinished_draws() {
    for (const auto& draws : m_draws)
        if (!draws->is_done())
            return draws.get();
    return nullptr;
}

bool WarmUp::is_done() const {
    for (const auto& draws : m_draws)
        if (!draws->is_done())
            return false;
    return !m_views || m_views->pending() == 0;
}

bool WarmUp::draw_next(PassProgress& progress) {
    const gpu::ContextScope scope(m_context.get());
    FirstDraws* draws = unfinished_draws();
    if (!draws) {
        m_views->draw_next();
        return !progress.is_cancelled();
    }
    if (!progress.next(draws->next_pass()))
        return false;
    draws->draw_next();
    if (draws->is_done() && m_draws.size() > 1)
        m_draws.erase(m_draws.begin());  // frees its targets
    return true;
}

void WarmUp::draw_all(PassProgress& progress) {
    if (total() > 0)
        progress.begin(PassProgress::Step::drawing, total());
    while (!is_done() && !progress.is_cancelled() && draw_next(progress)) {
    }
}

std::unique_ptr<Executor> WarmUp::take_executor() {
    return m_draws.empty() ? nullptr : m_draws.back()->take_executor();
}
