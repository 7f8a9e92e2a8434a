#include "graph/warm_up/look_contexts.h"

#include "gpu/objects/draw.h"

#include <algorithm>
#include <utility>

LookContext::~LookContext() {
    const gpu::ContextScope scope(m_context.get());
    m_views.reset();
    m_making = {};
    m_programs = {};
}

void LookContext::build_view_programs() {
    if (std::exchange(m_has_programs, true))
        return;
    auto made = ViewPrograms::make();
    gpu::finish();  // they are used in another context
    if (made)
        m_making.set_value(std::make_shared<const ViewPrograms>(std::move(*made)));
    else
        m_making.set_value(fail(std::move(made.error())));
}

Result<FirstViews*> LookContext::views() {
    const MadePrograms& programs = m_programs.get();
    if (!programs)
        return fail(programs.error());
    if (!m_views)
        m_views.emplace(*programs);
    return &*m_views;
}

LookContexts::~LookContexts() {
    for (const auto& context : m_all)
        const gpu::ContextScope scope(&context->context());  // destroys its buried objects
}

std::shared_ptr<LookContext> LookContexts::acquire() {
    const auto is_free = [](const auto& context) { return context.use_count() == 1; };
    const auto free = std::ranges::find_if(m_all, is_free);
    if (free != m_all.end())
        return *free;
    if (m_has_failed)
        return nullptr;
    auto made = gpu::Context::shared_with(m_screen);
    m_has_failed = !made;
    return made ? m_all.emplace_back(std::make_shared<LookContext>(std::move(*made))) : nullptr;
}

void LookContexts::prepare_spare() {
    if (const auto context = acquire())
        context->build_view_programs();
}
