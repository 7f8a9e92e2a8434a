#include "lab/drawing_contexts.h"

#include <algorithm>

DrawingContexts::~DrawingContexts() {
    for (const auto& context : m_all)
        const gpu::ContextScope scope(context.get());  // what is buried there ends there
}

std::shared_ptr<gpu::Context> DrawingContexts::lend() {
    const auto is_free = [](const auto& context) { return context.use_count() == 1; };
    const auto free = std::ranges::find_if(m_all, is_free);
    if (free != m_all.end())
        return *free;
    if (m_has_failed)
        return nullptr;
    auto made = gpu::Context::shared_with(m_screen);
    m_has_failed = !made;
    return made ? m_all.emplace_back(std::move(*made)) : nullptr;
}
