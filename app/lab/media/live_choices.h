#pragma once

#include "lab/storage/background_work.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

/// A live source that the user can choose.
struct LiveChoice {
    std::string label;    // "Window: Terminal"
    std::string picture;  // "window:Terminal"

    bool operator==(const LiveChoice&) const = default;
};

/// The screen, the windows of other programs and the cameras of this machine.
class LiveChoices {
public:
    /// Lists them on a background thread, at most once a second. Call it while they are shown.
    void refresh();
    const std::vector<LiveChoice>& all() const { return m_all; }
    /// Why there are no windows; "": there are, or they were not listed yet.
    const std::string& problem() const { return m_problem; }

private:
    struct Listed {
        std::vector<LiveChoice> choices;
        std::string problem;
    };

    static Listed list();

    BackgroundWork<Listed> m_work;
    std::optional<std::chrono::steady_clock::time_point> m_begun;  // the last list
    std::vector<LiveChoice> m_all;
    std::string m_problem;
};
