// The part of Lab that draws with programs in which values that rest are constants.
#include "base/elapsed.h"
#include "lab/document/morphing.h"
#include "lab/lab.h"
#include "lab/trials/tryouts.h"
#include "model/look/value_changes.h"

#include <algorithm>

namespace {
constexpr double seconds_a_turn = 0.012;  // of first draws beside the picture

std::set<std::string> moving_in(const Modulations& modulations) {
    std::set<std::string> names;
    for (const auto& [name, modulation] : modulations)
        names.insert(name);
    return names;
}
}  // namespace

void Lab::forget_settling() {
    m_settling.seconds = 0.0;
    m_settling.is_asked = false;
    m_settling.arrival.reset();
    m_reloader.stop_settling();
}

// Whether nothing moves values, and nobody would have to wait for the machine.
bool Lab::may_settle() const {
    return m_applied && m_player.is_playing() && !is_loading() && !m_morphing &&
           !m_tryouts->is_busy() && !m_document->history().is_in_gesture() &&
           m_applied->values == m_settling.values &&
           m_applied->modulations == m_settling.modulations;
}

// Every turn.
void Lab::follow_settling(double wall_seconds) {
    constexpr double longest_turn = 0.1;
    constexpr double rest_seconds = 2.0;
    // What is compared with is drawn with the look's own programs.
    const bool rests = m_renderer->executor().is_settled() && !m_renderer->variant();
    m_reloader.set_rest(rests ? m_settling.rest : nullptr);
    if (!may_settle()) {
        forget_settling();
        if (m_applied) {
            follow_values(m_settling.values, m_applied->values);
            m_settling.modulations = m_applied->modulations;
        }
        return;
    }
    m_settling.seconds += std::min(wall_seconds, longest_turn);
    const bool is_due = m_settling.seconds > rest_seconds && !m_renderer->executor().is_settled();
    if (!m_settling.is_asked && is_due) {
        m_settling.is_asked = true;
        m_reloader.settle({.look = m_document->drawn_look(),
                           .rest = std::make_shared<const Rest>(
                               Rest{m_settling.values, m_renderer->executor().plan(),
                                    moving_in(m_settling.modulations)}),
                           .images = m_images});
    }
    if (auto made = m_reloader.take_settled(); made && made->programs)
        m_settling.arrival = std::make_unique<Arrival>(std::move(*made));
    if (!m_settling.arrival || is_amid_frame() ||
        !m_settling.arrival->go_on({m_reloader.drawn_with(), m_size.extent()}, seconds_a_turn))
        return;
    LoadedRequest made = std::exchange(m_settling.arrival, nullptr)->take();
    m_reloader.set_shown(joined(*m_programs, made.programs->passes));
    rest_with(std::move(*made.programs), moving_in(m_settling.modulations));
}

void Lab::rest_with(Programs settled, std::set<std::string> moving) {
    const Executor& executor = m_renderer->executor();
    m_settling.rest =
        std::make_shared<const Rest>(Rest{m_document->values(), executor.plan(), moving});
    m_reloader.set_rest(m_settling.rest);
    m_renderer->settle(std::move(settled), std::move(moving));
}

// Whether the picture is still drawn with the values that an edit was made ready for.
bool Lab::rests_as(const Rest& rest) const {
    return m_renderer && m_renderer->executor().is_settled() && !m_renderer->variant() &&
           m_applied && m_applied->values == m_document->values() &&
           moving_in(m_applied->modulations) == rest.moving &&
           changed_parameters(m_document->look(), rest.values, m_applied->values).empty();
}

// One whose values moved on meanwhile has no picture before its own programs can draw it.
void Lab::apply_edit(LoadedRequest loaded) {
    if (loaded.settled && !rests_as(*loaded.settled->rest)) {
        loaded.settled.reset();
        if (std::exchange(loaded.owes_draws, false)) {
            m_own = {.are_late = m_own.are_late, .edit = std::move(loaded)};
            return;
        }
    }
    apply(std::move(loaded));
}

// The edit's picture goes on as the former one was drawn, unless it is put together otherwise.
void Lab::draw_settled(SettledLook settled, bool owes_draws) {
    const Rest& rest = *settled.rest;
    const bool is_alike =
        std::ranges::equal(m_renderer->executor().plan().targets, rest.plan.targets, {},
                           &PlannedTarget::onto, &PlannedTarget::onto) &&
        changed_parameters(m_document->look(), rest.values, m_document->values()).empty();
    if (!owes_draws || !is_alike)
        m_reloader.set_shown(joined(*m_programs, settled.programs.passes));
    if (!is_alike)
        return;
    m_own.are_late = owes_draws;
    m_own.since = std::chrono::steady_clock::now();
    rest_with(std::move(settled.programs), rest.moving);
}

bool Lab::opens_another() const {
    const OpenRequest* const asked = m_reloader.request();
    return is_reading() && asked && m_opened && *asked != *m_opened &&
           !m_reloader.is_drawing_owed();
}

// Not beside what may take long to be opened: a first frame that does is the lesser evil.
bool Lab::waits_for_own_programs() const {
    const DocumentState& state = m_document->state();
    return m_own.are_late && m_applied && !opens_another() &&
           (state.values != m_applied->values || state.modulations != m_applied->modulations ||
            state.overrides != m_applied->overrides);
}

// Those of an edit that waits for them, or else of what is open.
LoadedRequest Lab::owed_draws() const {
    LoadedRequest owed;
    owed.request = m_own.edit ? m_own.edit->request : *m_opened;
    owed.look = m_own.edit ? m_own.edit->look : m_document->drawn_look();
    owed.programs = m_own.edit ? m_own.edit->programs : m_programs;
    owed.images = m_own.edit ? m_own.edit->images : m_images;
    return owed;
}

// Something else has ended the settled programs, and the picture is drawn with its own: they are
// not to be drawn with elsewhere at the same time, as their uniforms are the same.
void Lab::end_late_programs() {
    if (!m_own.are_late || m_renderer->executor().is_settled())
        return;
    if (!m_own.edit)
        m_reloader.stop_drawing_owed();
    if (!m_own.edit && m_reloader.is_drawing_owed())
        return;
    m_own = {.edit = std::move(m_own.edit)};
    m_renderer->claim_programs();
}

// Every turn, behind the picture, whose first frames have the machine to themselves; for a text
// that is saved again by then nothing was made in vain. What is read meanwhile may bring others,
// and goes first.
void Lab::follow_own_programs() {
    constexpr double pause_seconds = 0.3;
    if (m_own.edit && !m_reloader.is_newest(*m_own.edit))
        m_own = {.are_late = m_own.are_late};
    end_late_programs();
    if ((!m_own.are_late && !m_own.edit) || is_amid_frame())
        return;
    if (auto drawn = m_reloader.take_drawn())
        m_own.arrival = std::make_unique<Arrival>(std::move(*drawn));
    if (!m_own.arrival) {
        const bool is_asked_for = m_own.edit || waits_for_own_programs();
        if (!is_asked_for && seconds_since(m_own.since) < pause_seconds)
            return;
        if (!m_reloader.is_drawing_owed() && !m_reloader.is_busy() && !m_arrival)
            m_reloader.draw_owed(owed_draws());
        return;
    }
    if (!m_own.arrival->go_on({m_reloader.drawn_with(), m_size.extent()}, seconds_a_turn))
        return;
    OwnPrograms own = std::exchange(m_own, {});
    if (own.edit)
        apply(std::move(*own.edit));
    else
        m_reloader.set_shown(joined(*m_programs, m_reloader.drawn_with()->passes));
}
