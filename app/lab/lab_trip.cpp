// The part of Lab that stops the clock at a number that is not finite.
#include "base/text.h"
#include "lab/lab.h"
#include "lab/offline/trip_words.h"

#include <algorithm>

void Lab::set_guard() {
    using Guard = Executor::Guard;
    if (m_player.is_playing()) {
        m_trip.plays_after = false;
        if (m_trip.trip)
            answer_trip(TripAnswer::go_on);
    }
    const bool clamps = m_trip.is_unattended || m_trip.answer == TripAnswer::clamp;
    const bool is_first = !m_renderer->has_drawn();  // what it remembers is looked at with the next
    Guard guard = m_player.is_playing() ? Guard::watch : Guard::search;
    if (m_trip.answer == TripAnswer::go_on || (is_first && guard == Guard::watch))
        guard = Guard::off;
    else if (clamps)
        guard = Guard::clamp;
    if (clamps && m_trip.trip) {
        m_trip.trip.reset();
        m_renderer->mend();
    }
    m_messages.succeeded(m_renderer->set_guard(guard));
}

// Once time has stopped, the past that is drawn again shows which pass began it.
void Lab::follow_trip() {
    const bool is_replaying = m_renderer->replay().is_running();
    if (m_trip.trip) {
        if (is_replaying)
            return;
        if (const auto first = m_renderer->take_trip(true);
            first && first->frame <= m_trip.trip->frame)
            m_trip.trip = first;
        return;
    }
    if (const auto trip = m_renderer->take_trip()) {
        stop_at(*trip);
        return;
    }
    if (m_trip.plays_after && !m_wanted && !is_replaying && !m_renderer->awaits_trip())
        m_player.play();
}

// Some frames have been drawn since: the past is drawn again up to the frame that it came in, so
// that its history is as good as it was, and the number itself can be looked at.
void Lab::stop_at(const Trip& trip) {
    if (m_renderer->executor().guard() == Executor::Guard::clamp) {
        if (!m_trip.has_told && m_trip.answer != TripAnswer::clamp) {
            Diagnostic problem = diagnostic_of(trip, m_renderer->executor().look());
            problem.message = with_sentence(problem.message, "NaN and Inf are clamped.");
            m_messages.say(problem);
        }
        m_trip.has_told = true;
        return;
    }
    m_trip.trip = trip;
    if (!m_player.is_playing())
        return;
    m_trip.plays_after = true;
    m_player.pause();
    m_player.go_back_to(trip.frame);
    set_guard();
    const auto all = static_cast<std::size_t>(std::max(m_document->look().settle_frames, 1));
    m_renderer->start_replay(m_player, all);
    m_wanted.reset();
}

// Another value may be the cure.
void Lab::reconsider_trip(const Redraw& redraw) {
    if (m_trip.trip && (redraw.needs_replay || redraw.passes[m_trip.trip->pass]))
        m_trip.trip.reset();
}

void Lab::forget_trip() {
    m_trip.trip.reset();
    m_trip.answer.reset();
    m_trip.has_told = false;
}

void Lab::answer_trip(TripAnswer answer) {
    if (!m_trip.trip)
        return;
    m_trip.trip.reset();
    m_renderer->cancel_replay();
    if (answer == TripAnswer::clear) {
        m_renderer->clear_history();
    } else {
        m_trip.answer = answer;
        if (answer == TripAnswer::clamp)
            m_renderer->mend();
    }
    m_player.play();
}
