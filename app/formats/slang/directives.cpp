#include "formats/slang/directives.h"

#include "base/text.h"

#include <optional>

namespace {
using DirectiveKind = SlangDirective::Kind;

// Takes the first word from `text`.
std::string_view take_word(std::string_view& text) {
    text = trim(text);
    const std::size_t end = std::min(text.find_first_of(" \t\"'<"), text.size());
    const std::string_view word = text.substr(0, end);
    text = trim(text.substr(end));
    return word;
}

struct Found {
    DirectiveKind kind;
    std::string_view argument;
};

Found include_of(DirectiveKind kind, std::string_view rest) {
    const std::size_t close = rest.find('"', 1);
    if (rest.empty() || rest.front() != '"' || close == std::string_view::npos || close == 1)
        return {DirectiveKind::damaged_include, rest};
    return {kind, rest.substr(1, close - 1)};
}

std::optional<Found> pragma_of(std::string_view rest) {
    const std::string_view word = take_word(rest);
    if (word == "include_optional")
        return include_of(DirectiveKind::include_optional, rest);
    if (word == "stage")
        return Found{DirectiveKind::stage, rest};
    if (word == "name")
        return Found{DirectiveKind::name, rest};
    if (word == "format")
        return Found{DirectiveKind::format, rest};
    if (word == "parameter")
        return Found{DirectiveKind::parameter, rest};
    return std::nullopt;
}

// The directive of a line that starts with '#' after whitespace.
std::optional<Found> directive_of(std::string_view line) {
    std::string_view rest = trim(line).substr(1);
    const std::string_view word = take_word(rest);
    if (word == "include")
        return include_of(DirectiveKind::include, rest);
    if (word == "pragma")
        return pragma_of(rest);
    if (word == "line")
        return Found{DirectiveKind::line, rest};
    return std::nullopt;
}

// Whether a block comment is open at the end of a line.
bool is_comment_open_after(std::string_view line, bool is_open) {
    const std::size_t first = std::min(line.find(is_open ? '*' : '/'), line.size());
    for (std::size_t i = first; i + 1 < line.size(); ++i) {
        const std::string_view two = line.substr(i, 2);
        if (!is_open && two == "//")
            return false;
        if (two != (is_open ? "*/" : "/*"))
            continue;
        is_open = !is_open;
        ++i;
    }
    return is_open;
}
}  // namespace

std::vector<SlangDirective> find_slang_directives(std::string_view text) {
    std::vector<SlangDirective> directives;
    bool is_in_comment = false;
    int number = 1;
    for (std::size_t begin = 0; begin < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        const std::string_view line = text.substr(begin, end - begin);
        const std::size_t first = line.find_first_not_of(" \t");
        const bool is_obeyed = first == 0 || !is_in_comment;
        if (first != std::string_view::npos && line[first] == '#' && is_obeyed)
            if (const auto found = directive_of(line))
                directives.push_back({found->kind, found->argument, begin, end, number});
        is_in_comment = is_comment_open_after(line, is_in_comment);
        begin = end;
    }
    return directives;
}
