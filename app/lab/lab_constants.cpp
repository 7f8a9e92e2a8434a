// The part of Lab that draws with other constants in the texts of the look.
#include "lab/lab.h"
#include "lab/trials/tryouts.h"

#include <algorithm>

void Lab::apply_constants(BuiltLook built) {
    if (!m_document || !m_renderer || m_document->is_restacking())
        return;
    if (built.kind == JobKind::variant_constants)
        return m_constants.set_variant({std::move(*built.look), std::move(*built.programs)});
    const Values before = m_document->look().constants;
    m_loader.programs().set(std::move(*built.programs));
    m_specialization.stop();
    m_tryouts->stop();  // they draw with the previous programs
    m_document->replace_look(std::move(*built.look));
    const Look& look = m_document->look();
    std::vector<std::string> turned;
    for (const auto& [name, value] : look.constants)
        if (const auto former = before.find(name);
            former == before.end() || former->second != value)
            turned.push_back(name);
    m_messages.succeeded(m_renderer->replace(Renderer::Whose::picture, m_document->drawn_look(),
                                             m_loader.programs().generic()));
    set_pass_switches(m_switches);
    show_images(built.images);
    m_renderer->restart_samples();
    m_drawn_extent = {};  // other uniforms may count now
    const Redraw redraw = redraw_after(look, turned);
    reconsider_trip(redraw);
    want(redraw);
}

// The picture may have got other programs since, or the variant those that it waited for.
void Lab::follow_variant_constants() {
    if (!m_variant || !m_renderer->variant())
        return;
    const Look& look = m_document->look();
    const Values wanted = constants_of(look, m_variant->values);
    const Look& drawn = m_renderer->variant()->look();
    if (drawn.constants == wanted || !m_constants.has_programs_for(*m_document, m_variant->values))
        return;
    const bool is_as_picture = wanted == look.constants;
    const Look next = with_overrides(is_as_picture ? look : m_constants.variant()->look,
                                     m_document->state().overrides);
    const Programs& programs =
        is_as_picture ? m_loader.programs().generic() : m_constants.variant()->programs;
    if (m_messages.succeeded(m_renderer->replace(Renderer::Whose::variant, next, programs)))
        want({{}, true});
}
