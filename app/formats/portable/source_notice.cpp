#include "formats/portable/source_notice.h"

#include "base/text.h"

#include <algorithm>
#include <array>
#include <vector>

namespace {
constexpr std::array license_words{"license",
                                   "licence",
                                   "public domain",
                                   "copyright",
                                   "(c)",
                                   "permission is hereby",
                                   "all rights reserved"};
constexpr std::array author_words{"author", "written by", "created by", "ported by"};

template <class Words>
bool has_any(const std::string& lower, const Words& words) {
    return std::ranges::any_of(
        words, [&](const char* word) { return lower.find(word) != std::string::npos; });
}

// The text of a comment line without marks such as "//", "*" or "***".
std::string without_marks(std::string_view line) {
    constexpr std::string_view marks = "/*\t ";
    const std::size_t first = line.find_first_not_of(marks);
    if (first == std::string_view::npos)
        return "";
    return std::string(line.substr(first, line.find_last_not_of(marks) - first + 1));
}

std::string without_marks_of_lines(std::string_view comment) {
    std::string text;
    for (const std::string_view line : split(comment, '\n'))
        if (const std::string words = without_marks(line); !words.empty())
            text += (text.empty() ? "" : "\n") + words;
    return text;
}

// The comments of a text. Line comments on consecutive lines are one comment.
std::vector<std::string> comments_of(std::string_view glsl) {
    std::vector<std::string> comments;
    std::size_t line_end = std::string_view::npos;  // of the previous line comment
    for (std::size_t at = 0; at + 1 < glsl.size();) {
        if (glsl.substr(at, 2) == "/*") {
            const std::size_t end = std::min(glsl.find("*/", at + 2), glsl.size());
            comments.emplace_back(glsl.substr(at, end - at));
            at = end + 2;
            line_end = std::string_view::npos;
        } else if (glsl.substr(at, 2) == "//") {
            const std::size_t end = std::min(glsl.find('\n', at), glsl.size());
            const bool continues =
                line_end != std::string_view::npos &&
                glsl.substr(line_end, at - line_end).find_first_not_of(" \t\n\r") ==
                    std::string_view::npos;
            if (continues)
                comments.back() += "\n" + std::string(glsl.substr(at, end - at));
            else
                comments.emplace_back(glsl.substr(at, end - at));
            at = line_end = end;
        } else {
            ++at;
        }
    }
    return comments;
}

std::string spdx_identifier(const std::string& comment) {
    constexpr std::string_view tag = "SPDX-License-Identifier:";
    const std::size_t at = comment.find(tag);
    if (at == std::string::npos)
        return "";
    const std::size_t end = std::min(comment.find('\n', at), comment.size());
    return without_marks(std::string_view(comment).substr(at + tag.size(), end - at - tag.size()));
}
}  // namespace

SourceNotice source_notice(std::string_view glsl) {
    SourceNotice notice{"not stated", ""};
    for (const std::string& comment : comments_of(glsl)) {
        const std::string lower = to_lower(comment);
        const bool has_license = has_any(lower, license_words);
        if (!has_license && !has_any(lower, author_words))
            continue;
        notice.text += (notice.text.empty() ? "" : "\n\n") + without_marks_of_lines(comment);
        if (const std::string spdx = spdx_identifier(comment); !spdx.empty())
            notice.license = spdx;
        else if (has_license && notice.license == "not stated")
            notice.license = "see comments";
    }
    return notice;
}
