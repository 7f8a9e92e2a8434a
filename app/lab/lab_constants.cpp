// The part of Lab that turns numbers in the texts of a look: it has its programs made anew beside
// the picture, which goes on with the former ones.
#include "lab/lab.h"
#include "lab/trials/tryouts.h"

#include <algorithm>

bool Lab::is_reading() const {
    return m_reloader.is_reading() ||
           (m_arrival && m_arrival->loaded().whose == LoadedRequest::Whose::look);
}

// What was asked for will not come any more.
void Lab::forget_constants() {
    m_asked_constants.reset();
    m_asked_variant_constants.reset();
    m_variant_programs.reset();
}

bool Lab::is_following_constants() const {
    const Look& look = m_document->look();
    return constants_of(look, m_document->values()) != look.constants;
}

// Every turn. Each state is asked for once, so that one that does not compile is not tried again.
void Lab::follow_constants() {
    if (is_reading() || !m_opened || m_document->is_restacking())
        return;
    const Look& look = m_document->look();
    Values wanted = constants_of(look, m_document->values());
    if (wanted == m_asked_constants.value_or(look.constants))
        return;
    OpenRequest request = *m_opened;
    request.constants = wanted;
    m_asked_constants = std::move(wanted);
    m_reloader.turn(request, LoadedRequest::Whose::turned);
}

void Lab::apply_turned(LoadedRequest loaded) {
    if (!m_document || !m_renderer || m_document->is_restacking())
        return;
    const bool is_made = loaded.look && loaded.programs;
    if (loaded.whose == LoadedRequest::Whose::turned) {
        if (m_unopened.empty()) {
            m_messages.set_look_problems(loaded.problems);
            gather_problems();
        }
        if (is_made)
            apply_turned_picture(std::move(loaded));
    } else if (is_made) {
        m_variant_programs = TurnedPrograms{std::move(*loaded.look), std::move(*loaded.programs)};
    } else if (!loaded.problems.empty()) {
        m_messages.say(loaded.problems.front());
    }
}

void Lab::apply_turned_picture(LoadedRequest loaded) {
    const Values before = m_document->look().constants;
    m_opened->constants = loaded.request.constants;
    m_programs = std::move(*loaded.programs);
    m_reloader.set_shown(*m_programs);
    forget_settling();
    m_tryouts->stop();  // they draw with the former ones
    m_document->replace_look(std::move(*loaded.look));
    const Look& look = m_document->look();
    std::vector<std::string> turned;
    for (const auto& [name, value] : look.constants)
        if (const auto former = before.find(name);
            former == before.end() || former->second != value)
            turned.push_back(name);
    m_messages.succeeded(
        m_renderer->replace(Renderer::Whose::picture, m_document->drawn_look(), *m_programs));
    set_pass_switches(m_switches);
    show_images(loaded.images);
    m_renderer->restart_samples();
    m_drawn_extent = {};  // other uniforms may count now
    const Redraw redraw = redraw_after(look, turned);
    reconsider_trip(redraw);
    want(redraw);
}

// Asks for them where there are none; what is compared goes on as it was until they are there.
bool Lab::has_programs_for(const Variant& variant) {
    const Look& look = m_document->look();
    Values wanted = constants_of(look, variant.values);
    if (wanted == look.constants ||
        (m_variant_programs && m_variant_programs->look.constants == wanted))
        return true;
    const bool is_under_way = wanted == m_asked_constants || wanted == m_asked_variant_constants;
    if (is_under_way || is_reading() || !m_opened)
        return false;
    OpenRequest request = *m_opened;
    request.constants = wanted;
    m_asked_variant_constants = std::move(wanted);
    m_reloader.turn(request, LoadedRequest::Whose::variant);
    return false;
}

// The picture may have got other programs since, or the variant those that it waited for.
void Lab::follow_variant_constants() {
    if (!m_variant || !m_renderer->variant())
        return;
    const Look& look = m_document->look();
    const Values wanted = constants_of(look, m_variant->values);
    const Look& drawn = m_renderer->variant()->look();
    if (drawn.constants == wanted || !has_programs_for(*m_variant))
        return;
    const bool is_as_picture = wanted == look.constants;
    const Look next = with_overrides(is_as_picture ? look : m_variant_programs->look,
                                     m_document->state().overrides);
    const Programs& programs = is_as_picture ? *m_programs : m_variant_programs->programs;
    if (m_messages.succeeded(m_renderer->replace(Renderer::Whose::variant, next, programs)))
        want({{}, true});
}
