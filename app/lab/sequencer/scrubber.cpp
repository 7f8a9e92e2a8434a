#include "lab/sequencer/scrubber.h"

#include "lab/frame/replay_length.h"

#include <algorithm>

void Scrubber::step_back() {
    if (!m_work.document || !m_work.renderer)
        return;
    Player& player = m_work.player;
    player.pause();
    if (player.transport().past().size() < 2)
        return m_work.messages.say("This is the first frame since the restart or the last scrub.");
    player.go_back_to(player.transport().past().back().number - 1);
    m_work.renderer->replay().cancel();
    m_work.redraw.add_full_replay();
}

void Scrubber::scrub(double seconds) {
    const double wanted = std::max(seconds, 0.0);
    if (m_work.player.transport().is_playing())
        m_work.player.seek(wanted);
    else
        m_wanted = wanted;
}

void Scrubber::update() {
    if (!m_wanted || !m_work.document || !m_work.renderer ||
        m_work.renderer->has_unfinished_frame() || m_work.renderer->replay().is_running())
        return;
    m_work.player.seek_with_past(*m_wanted, settling_frames(m_work));
    m_wanted.reset();
    if (m_work.player.transport().past().empty()) {  // the start
        m_work.renderer->clear_history();
        m_work.player.step();
    } else {
        m_work.redraw.add_replay();
    }
}
