#include "lab/media/render_size.h"

#include <algorithm>

ViewShape RenderSize::shape() const {
    if (m_chosen.shape)
        return *m_chosen.shape;
    const bool keeps_source = m_document && m_document->look().driven_by == Driver::picture &&
                              m_document->look().manifest.filename() != "look.json";
    return keeps_source ? ViewShape::source : ViewShape::view;
}

Extent RenderSize::extent() const {
    if (m_is_overlay)
        return m_chosen.scaled(m_view);
    const Source* source = m_media.source().get();
    const bool has_source = m_document && m_document->look().driven_by == Driver::picture && source;
    const Extent room = m_chosen.room(m_view);
    if (!has_source || !m_chosen.has_shape())
        return m_chosen.scaled(room);
    return m_chosen.scaled(
        shaped(room, shape(), source->extent(), pixel_aspect(source->spec(), source->extent())));
}

void RenderSize::set_view(Extent view_pixels, bool is_overlay) {
    m_is_overlay = is_overlay;
    if (view_pixels != m_view || !m_view_seconds)
        m_view_seconds = 0.0;
    m_view = view_pixels;
}

void RenderSize::fix_to_view() {
    m_chosen = fixed_in(m_chosen, m_view);
}

void RenderSize::update(double wall_seconds) {
    constexpr double steady_seconds = 0.5;
    constexpr double longest_update = 0.1;  // idle time does not count
    if (m_is_overlay || !m_chosen.is_to_be_chosen() || !m_document || !m_view_seconds)
        return;
    *m_view_seconds += std::min(wall_seconds, longest_update);
    if (*m_view_seconds > steady_seconds)
        fix_to_view();
}
