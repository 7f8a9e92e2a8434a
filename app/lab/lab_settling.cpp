// The part of Lab that draws with programs in which values that rest are constants.
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
        !m_settling.arrival->go_on({m_reloader.shown(), m_size.extent()}, seconds_a_turn))
        return;
    LoadedRequest made = std::exchange(m_settling.arrival, nullptr)->take();
    m_reloader.set_shown(joined(*m_programs, *made.programs));
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

// An edit was built for values that were static when it began.
void Lab::apply_edit(LoadedRequest loaded) {
    if (loaded.settled && !rests_as(*loaded.settled->rest))
        loaded.settled.reset();
    apply(std::move(loaded));
}

// Another plan needs other specialised programs.
void Lab::draw_settled(SettledLook settled) {
    const Rest& rest = *settled.rest;
    const bool is_alike =
        std::ranges::equal(m_renderer->executor().plan().targets, rest.plan.targets, {},
                           &PlannedTarget::onto, &PlannedTarget::onto) &&
        changed_parameters(m_document->look(), rest.values, m_document->values()).empty();
    m_reloader.set_shown(joined(*m_programs, settled.programs));
    if (is_alike)
        rest_with(std::move(settled.programs), rest.moving);
}
