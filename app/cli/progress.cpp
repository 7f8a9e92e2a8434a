#include "cli/progress.h"

#include "io/system/standard_streams.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <utility>

namespace {
// Arguments: finished, total, rate, decimals of the rate, seconds left.
const char* pattern_of(Progress::Kind work) {
    switch (work) {
        case Progress::Kind::rendering_pictures:
            return "\rRendering: {} of {} pictures, {:.{}f} pictures/s, {:.0f} s left\033[K";
        case Progress::Kind::showing_frames:
            return "\rFrame {0}, {2:.{3}f} frames/s. Press Ctrl+C to stop.\033[K";
        case Progress::Kind::checking_files:
            return "\rChecking: {} of {} files, {:.{}f} files/s, {:.0f} s left\033[K";
        case Progress::Kind::finding_period:
            return "\rFinding the period: {} of at most {} frames, {:.{}f} frames/s, {:.0f} s at "
                   "most\033[K";
        case Progress::Kind::rendering_frames:
            break;
    }
    return "\rRendering: {} of {} frames, {:.{}f} frames/s, {:.0f} s left\033[K";
}
}  // namespace

Progress::Progress(Kind work, int total)
    : m_work(work), m_total(total), m_is_shown(is_terminal(standard_error)) {}

Progress::~Progress() {
    if (m_has_shown)
        std::cerr << "\r\033[K";
}

void Progress::show(int done) {
    const auto now = Clock::now();
    if (!m_is_shown || now - m_last < std::chrono::milliseconds(100))
        return;
    m_last = now;
    m_has_shown = true;
    const double gone = std::chrono::duration<double>(now - m_start).count();
    const double rate = done / gone;
    std::cerr << fmt::format(fmt::runtime(pattern_of(m_work)), done, m_total, rate,
                             rate < 10.0 ? 1 : 0, (m_total - done) / std::max(rate, 1e-9));
}

OpeningLine::OpeningLine()
    : m_progress([this](const PassProgress::State& state) { show(state); }) {}

void OpeningLine::clear() {
    if (std::exchange(m_has_shown, false))
        std::cerr << "\r\033[K";
}

void OpeningLine::show(const PassProgress::State& state) {
    const auto now = Clock::now();
    if (!is_terminal(standard_error) || now - m_last < std::chrono::milliseconds(100))
        return;
    m_last = now;
    m_has_shown = true;
    std::cerr << fmt::format("\r{}\033[K", to_string(state));
}
