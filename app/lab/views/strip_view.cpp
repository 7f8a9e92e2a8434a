#include "lab/views/strip_view.h"

void StripView::set_context(std::shared_ptr<ContextViews> context) {
    m_context = std::move(context);
    if (!m_context)
        m_thumbnails.stop();
}

// Alternates between thumbnails and meters: the first of each can be slow with some drivers.
void StripView::update(const Executor& executor, const Values& values, int height, double seconds) {
    if (height <= 0) {
        m_thumbnails.stop();
        return m_context->gains.stop();
    }
    const gpu::ContextScope scope(m_context->context.get());
    m_measures_gains = !m_measures_gains;
    if (m_measures_gains)
        m_context->gains.update(executor, values, seconds);
    else
        m_thumbnails.update(m_context->viewer, executor, values, height, seconds);
}
