#include "lab/frame/nan_guard.h"

#include "base/text.h"
#include "lab/offline/trip_words.h"

#include <algorithm>

void NanGuard::prepare() {
    using Guard = Executor::Guard;
    if (m_work.player.is_playing()) {
        m_plays_after = false;
        if (m_found)
            answer(TripAnswer::go_on);
    }
    const bool clamps = m_is_unattended || m_answer == TripAnswer::clamp;
    const bool is_first =
        !m_work.renderer->has_drawn();  // its history is checked with the next frame
    Guard guard = m_work.player.is_playing() ? Guard::watch : Guard::search;
    if (m_answer == TripAnswer::go_on || (is_first && guard == Guard::watch))
        guard = Guard::off;
    else if (clamps)
        guard = Guard::clamp;
    if (clamps && m_found) {
        m_found.reset();
        m_work.renderer->mend();
    }
    m_work.messages.succeeded(m_work.renderer->set_guard(guard));
}

// While the clock is paused, the replay shows which pass wrote the first one.
void NanGuard::update() {
    const bool is_replaying = m_work.renderer->replay().is_running();
    if (m_found) {
        if (is_replaying)
            return;
        if (const auto first = m_work.renderer->take_trip(true);
            first && first->frame <= m_found->frame)
            m_found = first;
        return;
    }
    if (const auto trip = m_work.renderer->take_trip()) {
        stop_at(*trip);
        return;
    }
    if (m_plays_after && m_work.redraw.is_empty() && !is_replaying &&
        !m_work.renderer->awaits_trip())
        m_work.player.play();
}

// Some frames have been drawn since the finding. A replay up to its frame restores the history and
// shows the pixel.
void NanGuard::stop_at(const Trip& found) {
    if (m_work.renderer->executor().guard() == Executor::Guard::clamp) {
        if (!m_was_reported && m_answer != TripAnswer::clamp) {
            Diagnostic problem = diagnostic_of(found, m_work.renderer->executor().look());
            problem.message = with_sentence(problem.message, "NaN and Inf are clamped.");
            m_work.messages.say(problem);
        }
        m_was_reported = true;
        return;
    }
    m_found = found;
    if (!m_work.player.is_playing())
        return;
    m_plays_after = true;
    m_work.player.pause();
    m_work.player.go_back_to(found.frame);
    prepare();
    const auto all = static_cast<std::size_t>(std::max(m_work.document->look().settle_frames, 1));
    m_work.renderer->start_replay(m_work.player, all);
    m_work.redraw.clear();
}

void NanGuard::recheck(const Redraw& redraw) {
    if (m_found && (redraw.needs_replay || redraw.passes[m_found->pass]))
        m_found.reset();
}

void NanGuard::reset() {
    m_found.reset();
    m_answer.reset();
    m_was_reported = false;
}

void NanGuard::answer(TripAnswer wanted) {
    if (!m_found)
        return;
    m_found.reset();
    m_work.renderer->cancel_replay();
    if (wanted == TripAnswer::clear) {
        m_work.renderer->clear_history();
    } else {
        m_answer = wanted;
        if (wanted == TripAnswer::clamp)
            m_work.renderer->mend();
    }
    m_work.player.play();
}
