#include "formats/cues/cue_sheet.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace {
constexpr std::size_t max_cue_lines = 10'000;
constexpr double latest_cue = 86'400.0;      // s
constexpr double longest_change = 86'400.0;  // s

const std::vector<std::string>& cue_commands() {
    static const std::vector<std::string> names{"preset", "parameter", "restart", "blackout"};
    return names;
}

constexpr const char* cue_time_form = "a time up to 24:00:00, such as 1:23.5 or 83.5";

bool is_cue_blank(char letter) {
    return letter == ' ' || letter == '\t' || letter == '\r';
}

/// A word of a line. In quotes, it can contain blanks, `\"` and `\\`.
struct CueWord {
    std::string text;
    bool is_quoted = false;
    std::size_t begin = 0;  // in the line
    std::size_t end = 0;
};

std::optional<CueWord> read_quoted_word(std::string_view line, std::size_t at) {
    CueWord word{.text = {}, .is_quoted = true, .begin = at};
    for (++at; at < line.size(); ++at) {
        if (line[at] == '"') {
            word.end = at + 1;
            return word;
        }
        if (line[at] == '\\' && at + 1 < line.size())
            ++at;
        word.text += line[at];
    }
    return std::nullopt;
}

// Up to a comment; nullopt: a quote is not closed.
std::optional<std::vector<CueWord>> cue_words(std::string_view line) {
    std::vector<CueWord> words;
    std::size_t at = 0;
    while (at < line.size()) {
        if (is_cue_blank(line[at])) {
            ++at;
            continue;
        }
        if (line[at] == '#')
            break;
        if (line[at] == '"') {
            auto word = read_quoted_word(line, at);
            if (!word)
                return std::nullopt;
            at = word->end;
            words.push_back(std::move(*word));
            continue;
        }
        const std::size_t begin = at;
        while (at < line.size() && !is_cue_blank(line[at]))
            ++at;
        words.push_back({std::string(line.substr(begin, at - begin)), false, begin, at});
    }
    return words;
}

tl::unexpected<Diagnostics> cue_problem(std::string message) {
    return fail({{}, 0, std::move(message)});
}

using CueWords = std::span<const CueWord>;

// "morph 2" or "over 2" at the end of a line; 0 without it.
Result<double> cue_duration(CueWords words, std::string_view name) {
    if (words.empty())
        return 0.0;
    if (words.size() > 2 || words.front().text != name) {
        const CueWord& wrong = words.front().text == name ? words[2] : words.front();
        return cue_problem(fmt::format("expected '{} SECONDS' or the end of the line, got '{}'",
                                       name, wrong.text));
    }
    const auto seconds = words.size() == 2 ? parse_number(words[1].text) : std::nullopt;
    if (!seconds || *seconds < 0.0 || *seconds > longest_change)
        return cue_problem(fmt::format("expected seconds from 0 to 86400 after '{}'{}", name,
                                       words.size() == 2 ? ", got '" + words[1].text + "'" : ""));
    return *seconds;
}

Result<Cue> parse_preset_cue(Cue cue, CueWords words) {
    if (words.empty() || words.front().text.empty())
        return cue_problem("expected a preset name, such as preset \"Amber P3\"");
    cue.name = words.front().text;
    const auto over = cue_duration(words.subspan(1), "morph");
    if (!over)
        return fail(over.error());
    cue.over = *over;
    return cue;
}

// The value can have several words: `parameter tint 0.1 0.2 0.3 over 2`.
Result<Cue> parse_parameter_cue(Cue cue, CueWords words) {
    if (words.size() < 2 || words.front().text.empty())
        return cue_problem("expected a parameter and its value, such as parameter decay 0.9");
    cue.name = words.front().text;
    words = words.subspan(1);
    const auto is_over = [](const CueWord& word) { return !word.is_quoted && word.text == "over"; };
    const auto end = std::ranges::find_if(words, is_over);
    for (auto word = words.begin(); word != end; ++word)
        cue.value += (cue.value.empty() ? "" : " ") + word->text;
    if (cue.value.empty())
        return cue_problem(fmt::format("expected a value for '{}'", cue.name));
    const auto over = cue_duration({end, words.end()}, "over");
    if (!over)
        return fail(over.error());
    cue.over = *over;
    return cue;
}

Result<Cue> parse_blackout_cue(Cue cue, CueWords words) {
    if (words.size() != 1 || (words.front().text != "on" && words.front().text != "off"))
        return cue_problem("expected 'blackout on' or 'blackout off'");
    cue.is_on = words.front().text == "on";
    return cue;
}

Result<Cue> parse_command(Cue cue, const CueWord& name, CueWords rest) {
    const auto found = std::ranges::find(cue_commands(), name.text);
    if (found == cue_commands().end())
        return cue_problem(fmt::format("unknown command '{}'{}; use one of: {}", name.text,
                                       did_you_mean(name.text, cue_commands()),
                                       fmt::join(cue_commands(), ", ")));
    cue.command = static_cast<Cue::Command>(found - cue_commands().begin());
    switch (cue.command) {
        case Cue::Command::preset:
            return parse_preset_cue(std::move(cue), rest);
        case Cue::Command::parameter:
            return parse_parameter_cue(std::move(cue), rest);
        case Cue::Command::blackout:
            return parse_blackout_cue(std::move(cue), rest);
        case Cue::Command::restart:
            break;
    }
    if (!rest.empty())
        return cue_problem(
            fmt::format("'restart' takes no arguments, got '{}'", rest.front().text));
    return cue;
}

Result<Cue> cue_of(const std::vector<CueWord>& words) {
    const auto seconds = parse_cue_time(words.front().text);
    if (!seconds)
        return cue_problem(fmt::format("expected {}, got '{}'", cue_time_form, words.front().text));
    if (words.size() < 2)
        return cue_problem(
            fmt::format("expected a command after the time: {}", fmt::join(cue_commands(), ", ")));
    return parse_command({.seconds = *seconds}, words[1], CueWords(words).subspan(2));
}

// Always in quotes, so that every name reads back.
std::string quoted_name(const std::string& text) {
    return '"' + replace_all(replace_all(text, "\\", "\\\\"), "\"", "\\\"") + '"';
}

// A name or a value as one word if necessary: a label with blanks, or the word 'over'.
std::string value_word(const std::string& value) {
    const bool is_plain = value.find_first_not_of("0123456789.-+eE, ") == std::string::npos ||
                          value.find_first_of(" \t#\"\\") == std::string::npos;
    return is_plain && value != "over" && !value.empty() ? value : quoted_name(value);
}
}  // namespace

std::optional<double> parse_cue_time(std::string_view text) {
    const auto parts = split(text, ':');
    if (parts.size() > 3)
        return std::nullopt;
    double seconds = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const bool is_last = i + 1 == parts.size();
        const bool has_digits = !parts[i].empty() && parts[i].find_first_not_of(
                                                         is_last ? "0123456789." : "0123456789") ==
                                                         std::string_view::npos;
        const auto number = has_digits ? parse_number(parts[i]) : std::nullopt;
        if (!number || (i > 0 && *number >= 60.0))
            return std::nullopt;
        seconds = seconds * 60.0 + *number;
    }
    return seconds <= latest_cue ? std::optional(seconds) : std::nullopt;
}

std::string cue_time_text(double seconds) {
    const double rounded = std::round(std::clamp(seconds, 0.0, latest_cue) * 1000.0) / 1000.0;
    const double minutes = std::floor(rounded / 60.0);
    std::string rest = fmt::format("{:06.3f}", std::max(rounded - minutes * 60.0, 0.0));
    rest.erase(rest.find_last_not_of('0') + 1);
    if (rest.back() == '.')
        rest.pop_back();
    const double hours = std::floor(minutes / 60.0);
    return hours > 0.0 ? fmt::format("{:.0f}:{:02.0f}:{}", hours, minutes - hours * 60.0, rest)
                       : fmt::format("{:.0f}:{}", minutes, rest);
}

std::string cue_text(const Cue& cue) {
    std::string start =
        cue_time_text(cue.seconds) + " " + cue_commands()[static_cast<std::size_t>(cue.command)];
    switch (cue.command) {
        case Cue::Command::preset:
            return start + " " + quoted_name(cue.name) +
                   (cue.over > 0.0 ? " morph " + format_number(cue.over) : "");
        case Cue::Command::parameter:
            return start + " " + value_word(cue.name) + " " + value_word(cue.value) +
                   (cue.over > 0.0 ? " over " + format_number(cue.over) : "");
        case Cue::Command::blackout:
            return start + (cue.is_on ? " on" : " off");
        case Cue::Command::restart:
            break;
    }
    return start;
}

Result<Cue> parse_cue(std::string_view line) {
    const auto words = cue_words(line);
    if (!words)
        return cue_problem("missing closing quote (\")");
    if (words->empty())
        return cue_problem(fmt::format("expected {}", cue_time_form));
    return cue_of(*words);
}

Result<CueSheet> parse_cue_sheet(std::string_view text, const std::filesystem::path& file) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    CueSheet sheet;
    sheet.m_has_returns = text.find("\r\n") != std::string_view::npos;
    sheet.m_ends_with_line_end = text.empty() || text.back() == '\n';
    Diagnostics problems;
    std::vector<std::string_view> lines = split(text, '\n');
    if (sheet.m_ends_with_line_end)
        lines.pop_back();  // after the last line end
    if (lines.size() > max_cue_lines)
        return fail(
            {file, 0,
             fmt::format("the file has {} lines; the limit is {}", lines.size(), max_cue_lines)});
    int number = 0;
    for (std::string_view line : lines) {
        ++number;
        const bool has_mark = number == 1 && line.starts_with(byte_order_mark);
        const std::string_view content = has_mark ? line.substr(byte_order_mark.size()) : line;
        sheet.m_lines.push_back({std::string(line), {}});
        if (const std::string_view text_of_line = trim(content);
            text_of_line.empty() || text_of_line.front() == '#')
            continue;
        auto cue = parse_cue(content);
        if (cue)
            sheet.m_lines.back().cue = std::move(*cue);
        else
            problems.push_back({file, number, cue.error().front().message});
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return sheet;
}

std::string CueSheet::text() const {
    std::string text;
    for (std::size_t i = 0; i < m_lines.size(); ++i)
        text += m_lines[i].text + (i + 1 < m_lines.size() || m_ends_with_line_end ? "\n" : "");
    return text;
}

void CueSheet::add(const Cue& cue) {
    const auto is_later = [&](const CueLine& line) {
        return line.cue && line.cue->seconds > cue.seconds;
    };
    const auto at = std::ranges::find_if(m_lines, is_later);
    const char* line_end = m_has_returns ? "\r" : "";
    if (at == m_lines.end() && !m_ends_with_line_end) {
        m_lines.back().text += line_end;
        m_ends_with_line_end = true;
    }
    m_lines.insert(at, {cue_text(cue) + line_end, cue});
}

void CueSheet::change(LineNumber line, const Cue& cue) {
    if (line == 0 || line > m_lines.size())
        return;
    CueLine& changed = m_lines[line - 1];
    const auto words = cue_words(changed.text);
    const std::size_t end = words && !words->empty() ? words->back().end : 0;
    const std::string_view rest = std::string_view(changed.text).substr(end);
    const std::size_t indent = std::min(changed.text.find_first_not_of(" \t"), changed.text.size());
    changed = {changed.text.substr(0, indent) + cue_text(cue) + std::string(rest), cue};
}

void CueSheet::remove(LineNumber line) {
    if (line > 0 && line <= m_lines.size())
        m_lines.erase(m_lines.begin() + static_cast<std::ptrdiff_t>(line) - 1);
}
