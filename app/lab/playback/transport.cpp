#include "lab/playback/transport.h"

#include <algorithm>
#include <utility>

namespace {
constexpr double step_seconds = 1.0 / 60.0;
}

void Transport::set_speed(double speed) {
    m_speed = std::clamp(speed, 0.01, 4.0);
}

void Transport::set_longest_frame(double seconds) {
    m_longest_frame = std::clamp(seconds, 1.0 / 240.0, longest_frame_limit);
}

void Transport::restart(std::int64_t after, int subframes) {
    m_frame = after;
    m_subframe = {subframes - 1, subframes};  // the next one begins a source frame
    m_source_frame = after / subframes;
    m_past.clear();
    seek(0.0);
}

void Transport::seek(double seconds) {
    m_time = std::max(0.0, seconds);
}

void Transport::fill_past(std::size_t frames) {
    const auto since_start = static_cast<std::int64_t>(m_time / step_seconds);
    const auto maximum = static_cast<std::int64_t>(std::min(frames, frames_remembered));
    const std::int64_t count = std::min(since_start, maximum);
    m_past.clear();
    m_frame = since_start - count;
    for (std::int64_t left = count; left > 0; --left) {
        const auto ago = static_cast<double>(left) * step_seconds;
        m_past.push_back({++m_frame, {m_time - ago, m_time - ago + step_seconds}, {}, m_frame});
    }
    m_subframe = {};
    m_source_frame = m_frame;
}

bool Transport::go_back_to(std::int64_t frame) {
    if (m_past.empty() || frame < m_past.front().number || frame > m_past.back().number)
        return false;
    while (m_past.back().number > frame)
        m_past.pop_back();
    m_frame = frame;
    m_subframe = m_past.back().subframe;
    m_source_frame = m_past.back().source_number;
    seek(m_past.back().span.end);
    return true;
}

PlayedFrame Transport::add_frame(double end) {
    const bool continues = m_subframe.index + 1 < m_subframe.count;
    m_subframe =
        continues ? Subframe{m_subframe.index + 1, m_subframe.count} : Subframe{0, m_subframes};
    m_source_frame += continues ? 0 : 1;
    const PlayedFrame frame{++m_frame, {m_time, end}, m_subframe, m_source_frame};
    m_time = end;
    m_past.push_back(frame);
    if (m_past.size() > frames_remembered)
        m_past.pop_front();
    return frame;
}

std::optional<PlayedFrame> Transport::take_step() {
    if (!std::exchange(m_is_stepping, false))
        return std::nullopt;
    m_subframe = {};
    return add_frame(m_time + step_seconds);
}

std::optional<PlayedFrame> Transport::advance(const Elapsed& elapsed) {
    if (elapsed.seconds <= 0.0)
        return std::nullopt;
    const double shown = std::min(elapsed.seconds, m_longest_frame);
    const double share = shown / elapsed.seconds;
    const double of_two = std::max(share, std::exchange(m_last_share, share));
    constexpr double mean_seconds = 0.5;
    m_shown_share += std::min(elapsed.wall_seconds / mean_seconds, 1.0) * (of_two - m_shown_share);
    if (elapsed.skips_excess)
        m_time += elapsed.seconds - shown;
    return add_frame(m_time + shown);
}

std::optional<PlayedFrame> Transport::advance_to(double end) {
    if (end <= m_time)
        return std::nullopt;
    m_time = std::max(m_time, end - m_longest_frame);
    return add_frame(end);
}

PlayedFrame Transport::advance_fixed(double fps) {
    const TimeSpan span = frame_span(m_frame + 1, fps);
    m_time = span.start;
    return add_frame(span.end);
}
