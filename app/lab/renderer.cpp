#include "lab/renderer.h"

#include <algorithm>
#include <chrono>

namespace {
double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
}  // namespace

Frame Renderer::frame_of(const PlayedFrame& played, const Beam& beam) const {
    Frame frame;
    frame.time = played.span.end;
    frame.time_delta = played.span.seconds();
    frame.number = played.number;
    frame.mouse = m_mouse;
    frame.patience_seconds = m_patience_seconds;
    frame.beam = beam;
    return frame;
}

void Renderer::set_mouse(double x, double y) {
    const std::array<double, 2> mouse{x, y};
    if (mouse != m_mouse)
        m_executor.note_mouse_moved();
    m_mouse = mouse;
}

void Renderer::draw(const PlayedFrame& played, const Beam& beam) {
    const auto start = std::chrono::steady_clock::now();
    m_executor.draw(frame_of(played, beam));
    m_point_count = beam.size();
    m_pass_milliseconds = m_executor.pass_milliseconds();
    note_beam_cost(played);
    constexpr double smoothing = 0.1;
    m_frame_seconds += smoothing * (seconds_since(start) - m_frame_seconds);
}

void Renderer::note_beam_cost(const PlayedFrame& played) {
    const std::vector<Pass>& passes = m_executor.look().passes;
    double milliseconds = 0.0;
    for (std::size_t i = 0; i < std::min(passes.size(), m_pass_milliseconds.size()); ++i)
        if (passes[i].draw != Draw::fullscreen)
            milliseconds += m_pass_milliseconds[i];
    const double cost = milliseconds / 1000.0 / std::max(played.span.seconds(), 1e-6);
    constexpr double smoothing = 0.2;  // the driver's times are of some frames ago
    m_beam_cost = m_beam_cost == 0.0 ? cost : m_beam_cost + smoothing * (cost - m_beam_cost);
}

void Renderer::draw_unseen(const PlayedFrame& played, const Beam& beam) {
    const std::vector<bool> carried = carried_passes(m_executor.look());
    m_executor.draw(frame_of(played, beam), &carried);
}

void Renderer::redraw(const Player& player, const std::vector<bool>& passes) {
    if (player.past().empty())
        return;
    const PlayedFrame& present = player.past().back();
    m_executor.redraw(frame_of(present, player.trace(present.span)), passes);
}

void Renderer::start_replay(const Player& player, std::size_t frames) {
    const std::size_t there = player.past().size();
    m_replay = {0, std::min(frames, there)};
    m_replay_first = there - m_replay.total;
    if (m_replay.is_running())
        clear_history();
}

bool Renderer::continue_replay(const Player& player, double seconds, const BeforeFrame& before) {
    const auto start = std::chrono::steady_clock::now();
    while (m_replay.is_running() && seconds_since(start) < seconds) {
        const PlayedFrame& frame = player.past()[m_replay_first + m_replay.done];
        ++m_replay.done;
        before(frame);
        if (m_replay.is_running()) {
            draw_unseen(frame, player.trace(frame.span));
            continue;
        }
        draw(frame, player.trace(frame.span));
        return true;
    }
    return false;
}
