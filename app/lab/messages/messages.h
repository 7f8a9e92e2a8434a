#pragma once

#include "lab/messages/notice.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What the program reports to the user: one notice, and the list of problems.
class Messages {
public:
    /// Shows a notice for 5 seconds, a problem for 12. `subject` names what the problem is about (a
    /// file, a device), so that withdraw() finds it.
    void say(std::string text, bool is_problem = false, std::string subject = {});
    /// Shows a problem with little effect, as long as a problem.
    void warn(std::string text, std::string subject = {});
    /// Shows a problem as "FILE:LINE: MESSAGE".
    void say(const Diagnostic& problem);
    /// Shows a notice with a button for 8 seconds.
    void offer(std::string text, MenuEntry button);
    /// Shows a notice with buttons until the user chooses or dismisses it.
    void ask(std::string text, std::vector<MenuEntry> buttons, std::string subject = {},
             bool is_problem = true);
    /// Adds to the current notice. If it is a problem or missing, shows a new notice.
    void append(std::string text, MenuEntry button);
    /// The same with several buttons, for 12 seconds.
    void append(std::string text, std::vector<MenuEntry> buttons);
    /// Shows the first problem of a failed result. Returns whether it succeeded.
    template <class T>
    bool succeeded(const Result<T>& result) {
        if (!result)
            say(result.error().front());
        return result.has_value();
    }
    const std::optional<Notice>& notice() const { return m_notice; }
    void dismiss() { m_notice.reset(); }
    /// Removes the notice if it is a problem, and returns its text: it is shown elsewhere.
    std::optional<std::string> take_problem();
    /// Dismisses the notice about a subject: its problem is solved.
    void withdraw(std::string_view subject);
    /// Whether the notice disappears after a time.
    bool is_counting() const { return m_notice && m_notice->goes_by; }
    /// Counts down the time of the notice.
    void update(double wall_seconds);

    /// Problems of the open look, then those of its content.
    const std::vector<Problem>& problems() const { return m_problems; }
    void set_look_problems(const Diagnostics& problems);
    void add_look_problems(const Diagnostics& problems);
    /// Of signal, source and images.
    void set_content_problems(const Diagnostics& problems);
    /// Hides the problems until a new one occurs.
    void dismiss_problems() { m_are_problems_dismissed = true; }
    bool are_problems_dismissed() const { return m_are_problems_dismissed; }

private:
    bool lists(std::string_view subject) const;
    void join_problems();

    std::optional<Notice> m_notice;
    std::vector<Problem> m_look_problems;
    std::vector<Problem> m_content_problems;
    std::vector<Problem> m_problems;
    bool m_are_problems_dismissed = false;
};
