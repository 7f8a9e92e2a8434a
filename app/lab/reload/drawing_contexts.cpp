#include "lab/reload/drawing_contexts.h"

#include "gpu/objects/draw.h"

#include <algorithm>
#include <utility>

DrawingHome::~DrawingHome() {
    const gpu::ContextScope scope(m_context.get());
    m_views.reset();
    m_making = {};
    m_programs = {};
}

void DrawingHome::have_programs() {
    if (std::exchange(m_has_programs, true))
        return;
    auto made = ViewPrograms::make();
    gpu::finish();  // they are used in another context
    if (made)
        m_making.set_value(std::make_shared<const ViewPrograms>(std::move(*made)));
    else
        m_making.set_value(fail(std::move(made.error())));
}

Result<FirstViews*> DrawingHome::views() {
    const MadePrograms& programs = m_programs.get();
    if (!programs)
        return fail(programs.error());
    if (!m_views)
        m_views.emplace(*programs);
    return &*m_views;
}

DrawingContexts::~DrawingContexts() {
    for (const auto& home : m_all)
        const gpu::ContextScope scope(&home->context());  // what is buried there ends there
}

std::shared_ptr<DrawingHome> DrawingContexts::lend() {
    const auto is_free = [](const auto& home) { return home.use_count() == 1; };
    const auto free = std::ranges::find_if(m_all, is_free);
    if (free != m_all.end())
        return *free;
    if (m_has_failed)
        return nullptr;
    auto made = gpu::Context::shared_with(m_screen);
    m_has_failed = !made;
    return made ? m_all.emplace_back(std::make_shared<DrawingHome>(std::move(*made))) : nullptr;
}

void DrawingContexts::have_spare() {
    if (const auto home = lend())
        home->have_programs();
}
