#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

/// A part of a line of GLSL that has its own colour.
struct CodeSpan {
    enum class Kind { plain, keyword, type, call, number, comment, directive };

    std::size_t begin = 0;  // bytes in the line
    std::size_t end = 0;
    Kind kind = Kind::plain;

    bool operator==(const CodeSpan&) const = default;
};

/// Splits a line into spans that cover it in order. `starts_in_comment`: a block comment is open at
/// its start.
std::vector<CodeSpan> code_spans(std::string_view line, bool starts_in_comment);

/// For each line of a text, whether a block comment is open at its start.
std::vector<bool> lines_in_comments(const std::vector<std::string_view>& lines);
