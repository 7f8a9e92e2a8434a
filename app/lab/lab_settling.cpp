// The part of Lab that draws with programs in which values that rest are constants.
#include "lab/lab.h"
#include "lab/morphing.h"
#include "lab/tryouts.h"
#include "model/value_changes.h"

#include <algorithm>

namespace {
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
    constexpr double seconds_a_turn = 0.012;
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
                           .values = m_settling.values,
                           .plan = m_renderer->executor().plan(),
                           .moving = moving_in(m_settling.modulations),
                           .images = m_images});
    }
    if (auto made = m_reloader.take_settled(); made && made->programs)
        m_settling.arrival = std::make_unique<Arrival>(std::move(*made));
    if (!m_settling.arrival || is_amid_frame() ||
        !m_settling.arrival->go_on({m_reloader.drawn_with(), picture_extent()}, seconds_a_turn))
        return;
    LoadedRequest made = std::exchange(m_settling.arrival, nullptr)->take();
    m_renderer->settle(std::move(*made.programs), moving_in(m_settling.modulations));
}
