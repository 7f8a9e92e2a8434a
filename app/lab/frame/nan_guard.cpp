#include "lab/frame/nan_guard.h"

#include "base/text.h"
#include "lab/offline/non_finite_text.h"

#include <algorithm>

void NanGuard::prepare() {
    if (m_work.player.transport().is_playing()) {
        m_plays_after = false;
        if (m_found)
            set_action(NonFiniteAction::ignore);
    }
    const bool clamps = m_is_unattended || m_action == NonFiniteAction::clamp;
    const bool is_first =
        !m_work.renderer->has_drawn();  // its history is checked with the next frame
    NanPolicy policy =
        m_work.player.transport().is_playing() ? NanPolicy::watch : NanPolicy::search;
    if (m_action == NonFiniteAction::ignore || (is_first && policy == NanPolicy::watch))
        policy = NanPolicy::off;
    else if (clamps)
        policy = NanPolicy::clamp;
    if (clamps && m_found) {
        m_found.reset();
        m_watch->sanitize(m_work.renderer->executor());
    }
    m_work.messages.succeeded(m_watch->set_policy(policy, m_work.renderer->executors().picture()));
}

// While the clock is paused, the replay shows which pass wrote the first one.
void NanGuard::update() {
    const bool is_replaying = m_work.renderer->replay().is_running();
    if (m_found) {
        if (is_replaying)
            return;
        if (const auto first = m_watch->take(m_work.renderer->executor(), true);
            first && first->frame <= m_found->frame)
            m_found = first;
        return;
    }
    if (const auto found = m_watch->take(m_work.renderer->executor())) {
        stop_at(*found);
        return;
    }
    if (m_plays_after && m_work.redraw.is_empty() && !is_replaying && !m_watch->is_waiting())
        m_work.player.play();
}

// Some frames have been drawn since the finding. A replay up to its frame restores the history and
// shows the pixel.
void NanGuard::stop_at(const NonFinitePixel& found) {
    if (m_watch->policy() == NanPolicy::clamp) {
        if (!m_was_reported && m_action != NonFiniteAction::clamp) {
            Diagnostic problem = diagnostic_of(found, m_work.renderer->executor().look());
            problem.message = with_sentence(problem.message, "NaN and Inf are clamped.");
            m_work.messages.say(problem);
        }
        m_was_reported = true;
        return;
    }
    m_found = found;
    if (!m_work.player.transport().is_playing())
        return;
    m_plays_after = true;
    m_work.player.pause();
    m_work.player.go_back_to(found.frame);
    prepare();
    const auto all = static_cast<std::size_t>(std::max(m_work.document->look().settle_frames, 1));
    m_work.renderer->replay().start(m_work.player, all);
    m_work.redraw.clear();
}

void NanGuard::recheck(const Redraw& redraw) {
    if (m_found && (redraw.needs_replay || redraw.passes[m_found->pass]))
        m_found.reset();
}

void NanGuard::open() {
    reset();
    m_watch = std::make_shared<NanWatch>();
}

void NanGuard::reset() {
    m_found.reset();
    m_action.reset();
    m_was_reported = false;
}

void NanGuard::set_action(NonFiniteAction wanted) {
    if (!m_found)
        return;
    m_found.reset();
    m_work.renderer->replay().cancel();
    if (wanted == NonFiniteAction::clear) {
        m_work.renderer->clear_history();
    } else {
        m_action = wanted;
        if (wanted == NonFiniteAction::clamp)
            m_watch->sanitize(m_work.renderer->executor());
    }
    m_work.player.play();
}
