#include "lab/messages/messages.h"

#include "base/printable.h"
#include "lab/messages/source_lines.h"
#include "lab/storage/display_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

void Messages::say(std::string text, bool is_problem, std::string subject) {
    if (is_problem && !text.empty() && text.find(": ") == std::string::npos)
        text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    m_notice = Notice{.text = shortened(std::move(text), max_message_bytes),
                      .is_problem = is_problem,
                      .seconds_left = is_problem ? 12.0 : 5.0,
                      .subject = std::move(subject)};
}

void Messages::warn(std::string text, std::string subject) {
    say(std::move(text), true, std::move(subject));
    m_notice->is_problem = false;
    m_notice->is_warning = true;
}

void Messages::say(const Diagnostic& problem) {
    const std::string name = display_name(problem.file);
    const std::string line = problem.line > 0 ? fmt::format(":{}", problem.line) : std::string();
    say(name.empty() ? problem.message : fmt::format("{}{}: {}", name, line, problem.message), true,
        problem.file.string());
}

void Messages::offer(std::string text, MenuEntry button) {
    say(std::move(text));
    m_notice->buttons.push_back(std::move(button));
    m_notice->seconds_left = 8.0;
}

void Messages::ask(std::string text, std::vector<MenuEntry> buttons, std::string subject,
                   bool is_problem) {
    say(std::move(text), is_problem, std::move(subject));
    m_notice->buttons = std::move(buttons);
    m_notice->goes_by = false;
}

void Messages::append(std::string text, MenuEntry button) {
    const bool can_append =
        m_notice && !m_notice->is_problem && !m_notice->is_warning && m_notice->buttons.empty();
    say(can_append ? fmt::format("{} · {}", m_notice->text, text) : std::move(text));
    m_notice->buttons.push_back(std::move(button));
}

void Messages::append(std::string text, std::vector<MenuEntry> buttons) {
    append(std::move(text), MenuEntry());
    m_notice->buttons = std::move(buttons);
    m_notice->seconds_left = 12.0;
}

void Messages::withdraw(std::string_view subject) {
    if (m_notice && m_notice->subject == subject)
        m_notice.reset();
}

std::optional<std::string> Messages::take_problem() {
    if (!m_notice || !m_notice->is_problem)
        return std::nullopt;
    std::string text = std::move(m_notice->text);
    m_notice.reset();
    return text;
}

void Messages::update(double wall_seconds) {
    if (m_notice && m_notice->goes_by && (m_notice->seconds_left -= wall_seconds) <= 0.0)
        m_notice.reset();
}

void Messages::set_look_problems(const Diagnostics& problems) {
    m_look_problems.clear();
    add_look_problems(problems);
}

void Messages::add_look_problems(const Diagnostics& problems) {
    SourceLines lines;
    for (const Diagnostic& diagnostic : problems) {
        m_look_problems.push_back({diagnostic, lines.excerpt_of(diagnostic)});
        m_look_problems.back().diagnostic.message =
            shortened(diagnostic.message, max_message_bytes);
    }
    join_problems();
}

bool Messages::lists(std::string_view subject) const {
    return std::ranges::any_of(m_problems, [subject](const Problem& problem) {
        return problem.diagnostic.file == subject;
    });
}

void Messages::set_content_problems(const Diagnostics& problems) {
    m_content_problems.clear();
    for (const Diagnostic& problem : problems)
        m_content_problems.push_back({problem, {}});
    join_problems();
}

void Messages::join_problems() {
    const std::string subject = m_notice ? m_notice->subject : std::string();
    const bool was_listed = !subject.empty() && lists(subject);
    const std::vector<Problem> before = std::exchange(m_problems, m_look_problems);
    m_problems.insert(m_problems.end(), m_content_problems.begin(), m_content_problems.end());
    const auto is_new = [&before](const Problem& problem) {
        return std::ranges::find(before, problem.diagnostic, &Problem::diagnostic) == before.end();
    };
    if (std::ranges::any_of(m_problems, is_new))
        m_are_problems_dismissed = false;
    if (was_listed && !lists(subject))
        withdraw(subject);
}
