#include "cli/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <unistd.h>
#include <utility>

Progress::Progress(std::string what, int total, std::string unit)
    : m_what(std::move(what)),
      m_unit(std::move(unit)),
      m_total(total),
      m_is_shown(isatty(STDERR_FILENO) == 1) {}

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
    std::cerr << fmt::format("\r{}  {} of {} {}, {:.{}f} a second, {:.0f} s left\033[K", m_what,
                             done, m_total, m_unit, rate, rate < 10.0 ? 1 : 0,
                             (m_total - done) / std::max(rate, 1e-9));
}

OpeningLine::OpeningLine()
    : m_progress([this](const PassProgress::State& state) { show(state); }) {}

void OpeningLine::clear() {
    if (std::exchange(m_has_shown, false))
        std::cerr << "\r\033[K";
}

void OpeningLine::show(const PassProgress::State& state) {
    const auto now = Clock::now();
    if (isatty(STDERR_FILENO) != 1 || now - m_last < std::chrono::milliseconds(100))
        return;
    m_last = now;
    m_has_shown = true;
    std::cerr << fmt::format("\r{} ('{}')\033[K", words_of(state), state.pass);
}
