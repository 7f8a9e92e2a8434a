#include "lab/media/live_choices.h"

#include "io/capture/capture_list.h"

#include <fmt/format.h>

LiveChoices::Listed LiveChoices::list() {
    Listed listed;
    if (const auto titles = list_windows()) {
        listed.choices.push_back({"Screen", "screen:"});
        for (const std::string& title : *titles)
            listed.choices.push_back(
                {fmt::format("Window: {}", title), fmt::format("window:{}", title)});
    } else {
        listed.problem = titles.error().front().message;
    }
    for (const std::string& device : list_cameras())
        listed.choices.push_back(
            {fmt::format("Camera: {}", device), fmt::format("camera:{}", device)});
    return listed;
}

void LiveChoices::refresh() {
    constexpr std::chrono::seconds stays{1};
    m_work.update();
    if (const auto& outcome = m_work.outcome(); outcome && *outcome) {
        m_all = (*outcome)->choices;
        m_problem = (*outcome)->problem;
    }
    const auto now = std::chrono::steady_clock::now();
    if (!m_work.is_free() || (m_begun && now - *m_begun < stays))
        return;
    m_begun = now;
    m_work.start([](JobProgress&) -> Result<Listed> { return list(); });
}
