#include "lab/drawing_contexts.h"

#include <algorithm>
#include <utility>

DrawingHome::~DrawingHome() {
    const gpu::ContextScope scope(m_context.get());
    m_views.reset();
}

Result<FirstViews*> DrawingHome::views() {
    if (!m_views) {
        auto made = FirstViews::make();
        if (!made)
            return fail(made.error());
        m_views.emplace(std::move(*made));
    }
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
