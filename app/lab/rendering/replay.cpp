#include "lab/rendering/replay.h"

#include "base/elapsed.h"
#include "lab/rendering/renderer.h"

#include <algorithm>

void Replay::start(const Player& player, std::size_t frames) {
    m_renderer.executors().set_variant_alone(false);
    begin(player, frames);
}

void Replay::start_variant(const Player& player, std::size_t frames) {
    m_renderer.executors().set_variant_alone(true);
    begin(player, m_renderer.executors().variant() ? frames : 0);
}

void Replay::begin(const Player& player, std::size_t frames) {
    m_renderer.drop_frame();
    static_cast<void>(m_renderer.take_dropped_frame());  // it is replaced
    const std::size_t count = player.transport().past().size();
    m_done = 0;
    m_total = std::min(frames, count);
    m_first = count - m_total;
    m_is_of_variant = m_renderer.executors().is_variant_alone();
    if (is_running())
        m_renderer.clear_history();
    else
        m_renderer.executors().set_variant_alone(false);
}

void Replay::cancel() {
    if (is_running())
        m_renderer.drop_frame();
    m_done = m_total = 0;
    m_renderer.executors().set_variant_alone(false);
}

bool Replay::update(const Player& player, double seconds, const BeforeFrame& before) {
    const auto start = std::chrono::steady_clock::now();
    if (m_is_of_variant && !m_renderer.executors().variant())
        cancel();
    while (is_running() && seconds_since(start) < seconds) {
        const PlayedFrame& frame = player.transport().past()[m_first + m_done];
        const bool is_last = m_done + 1 == m_total;
        if (m_renderer.has_unfinished_frame()) {
            m_renderer.continue_frame(seconds - seconds_since(start));
        } else {
            before(frame);
            if (is_last)
                m_renderer.draw(frame, player.signal().trace(frame.span));
            else
                m_renderer.draw_unseen(frame, player.signal().trace(frame.span));
        }
        if (m_renderer.has_unfinished_frame())
            return false;
        if (m_renderer.take_dropped_frame())
            continue;  // repeats it
        ++m_done;
        if (!is_last)
            continue;
        m_renderer.executors().set_variant_alone(false);
        return true;
    }
    return false;
}
