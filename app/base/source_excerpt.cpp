#include "base/source_excerpt.h"

#include "base/printable.h"
#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace {
constexpr std::size_t max_columns = 200;
constexpr std::size_t tab_columns = 4;
constexpr std::string_view signs = "+-*/%<>=!&|^~?:";

struct Span {
    std::size_t begin = 0;
    std::size_t end = 0;
};

bool is_name_byte(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool is_sign(char c) {
    return signs.find(c) != std::string_view::npos;
}

// Whether the span is a whole word or sign: no character next to it continues it.
bool is_whole(std::string_view line, const Span& span) {
    const auto continues = [](char inside, char outside) {
        return (is_name_byte(inside) && is_name_byte(outside)) ||
               (is_sign(inside) && is_sign(outside));
    };
    return (span.begin == 0 || !continues(line[span.begin], line[span.begin - 1])) &&
           (span.end == line.size() || !continues(line[span.end - 1], line[span.end]));
}

// The first occurrence of a name, or the only one of a sign.
std::optional<Span> find_part(std::string_view line, std::string_view part) {
    std::optional<Span> found;
    for (std::size_t at = line.find(part); at != std::string_view::npos;
         at = line.find(part, at + 1)) {
        const Span span{at, at + part.size()};
        if (!is_whole(line, span))
            continue;
        if (is_name_byte(part.front()))
            return span;
        if (found)
            return std::nullopt;
        found = span;
    }
    return found;
}

std::optional<Span> find_quoted(std::string_view line, std::string_view message) {
    constexpr std::size_t longest = 256;
    constexpr std::string_view pass = "pass '";  // the message is about its code, not its name
    if (message.starts_with(pass))
        message.remove_prefix(std::min(message.find('\'', pass.size()) + 1, message.size()));
    std::size_t open = message.find('\'');
    while (open != std::string_view::npos) {
        const std::size_t close = message.find('\'', open + 1);
        if (close == std::string_view::npos)
            return std::nullopt;
        const std::string_view part = message.substr(open + 1, close - open - 1);
        if (!part.empty() && part.size() <= longest)
            if (const auto found = find_part(line, part))
                return found;
        open = message.find('\'', close + 1);
    }
    return std::nullopt;
}

std::string with_spaces(std::string_view line) {
    std::string text;
    for (const char c : line)
        if (c == '\t')
            text.append(tab_columns - text.size() % tab_columns, ' ');
        else
            text += c;
    return text;
}

// The byte of "(column 12)" in a message; `raw` is the line with tabs.
std::optional<Span> find_column(std::string_view raw, std::string_view message) {
    constexpr std::string_view word = "(column ";
    const std::size_t at = message.rfind(word);
    if (at == std::string_view::npos)
        return std::nullopt;
    const std::string_view rest = message.substr(at + word.size());
    const auto column = parse_integer(rest.substr(0, rest.find(')')));
    if (!column || *column < 1 || static_cast<std::size_t>(*column) > raw.size())
        return std::nullopt;
    const auto before = raw.substr(0, static_cast<std::size_t>(*column) - 1);
    const std::size_t begin = printable(with_spaces(before)).size();
    return Span{begin, begin + 1};
}

std::size_t indentation_of(std::string_view line) {
    return std::min(line.find_first_not_of(" "), line.size());
}

std::size_t column_count(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// The byte at which a column begins; the size of the text if it is shorter.
std::size_t byte_of_column(std::string_view text, std::size_t column) {
    std::size_t at = 0;
    for (; at < text.size(); ++at)
        if ((static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U && column-- == 0)
            return at;
    return at;
}

// The line from a column on, with "…" where it is cut.
std::string cut(const std::string& line, std::size_t first) {
    const std::size_t begin = byte_of_column(line, first);
    const std::size_t end = byte_of_column(line, first + max_columns);
    return (first > 0 && begin < line.size() ? "…" : "") + line.substr(begin, end - begin) +
           (end < line.size() ? "…" : "");
}

void remove_common_indentation(SourceExcerpt& excerpt) {
    std::size_t common = std::string::npos;
    for (const std::string& text : excerpt.lines)
        if (indentation_of(text) < text.size())
            common = std::min(common, indentation_of(text));
    if (common == std::string::npos)
        return;
    for (std::string& text : excerpt.lines)
        text.erase(0, common);
    excerpt.begin -= std::min(common, excerpt.begin);
    excerpt.end -= std::min(common, excerpt.end);
}

// Keeps the marked part of a long line.
void cut_long_lines(SourceExcerpt& excerpt) {
    constexpr std::size_t before_part = 60;
    const std::string line(excerpt.line());
    const std::size_t column = column_count(std::string_view(line).substr(0, excerpt.begin));
    const std::size_t first = column > max_columns / 2 ? column - before_part : 0;
    for (std::string& text : excerpt.lines)
        text = cut(text, first);
    if (first > 0) {
        const std::size_t removed = byte_of_column(line, first) - std::string_view("…").size();
        excerpt.begin -= removed;
        excerpt.end -= removed;
    }
    excerpt.end = std::min(excerpt.end, excerpt.line().size());
}
}  // namespace

SourceExcerpt excerpt_of(const std::vector<std::string_view>& lines, int line,
                         std::string_view message) {
    constexpr std::size_t most_bytes = std::size_t{64} * 1024;
    if (line < 1 || static_cast<std::size_t>(line) > lines.size())
        return {};
    const std::size_t at = static_cast<std::size_t>(line) - 1;
    const std::size_t first = at - std::min<std::size_t>(at, 1);
    const std::size_t last = std::min(at + 1, lines.size() - 1);
    SourceExcerpt excerpt{static_cast<int>(first) + 1, {}, at - first};
    for (std::size_t i = first; i <= last; ++i)
        excerpt.lines.push_back(printable(with_spaces(lines[i].substr(0, most_bytes))));
    auto part = find_column(lines[at].substr(0, most_bytes), message);
    if (!part)
        part = find_quoted(excerpt.line(), message);
    if (part) {
        excerpt.begin = part->begin;
        excerpt.end = part->end;
    }
    remove_common_indentation(excerpt);
    cut_long_lines(excerpt);
    return excerpt;
}

std::string to_string(const SourceExcerpt& excerpt) {
    std::string text;
    int number = excerpt.first_line;
    for (std::size_t i = 0; i < excerpt.lines.size(); ++i) {
        const std::string line = fmt::format("{:>5} | {}", number++, excerpt.lines[i]);
        text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
        if (i != excerpt.index || excerpt.begin == excerpt.end)
            continue;
        const std::string_view marked = excerpt.line();
        const std::size_t before = column_count(marked.substr(0, excerpt.begin));
        const std::size_t size =
            column_count(marked.substr(excerpt.begin, excerpt.end - excerpt.begin));
        text += fmt::format("      | {:{}}^{:~<{}}\n", "", before, "", size - 1);
    }
    return text;
}
