#pragma once

#include "base/pass_progress.h"

#include <chrono>

/// Progress of long work, on one line of stderr. Prints nothing if stderr is not a terminal.
class Progress {
public:
    enum class Kind {
        rendering_frames,
        rendering_pictures,
        showing_frames,  // without an end
        checking_files,
        finding_period,
    };

    Progress(Kind work, int total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(int done);

private:
    using Clock = std::chrono::steady_clock;

    Kind m_work;
    int m_total;
    bool m_is_shown;
    bool m_has_shown = false;
    Clock::time_point m_start = Clock::now();
    Clock::time_point m_last = m_start;
};

/// Progress of opening a look, on one line of stderr. Prints nothing if stderr is not a terminal.
class OpeningLine {
public:
    OpeningLine();
    ~OpeningLine() { clear(); }
    OpeningLine(const OpeningLine&) = delete;
    OpeningLine& operator=(const OpeningLine&) = delete;

    PassProgress& progress() { return m_progress; }
    /// Erases the line.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    void show(const PassProgress::State& state);

    PassProgress m_progress;
    Clock::time_point m_last = Clock::now();
    bool m_has_shown = false;
};
