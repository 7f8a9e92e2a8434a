#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

/// A line of a .slang text that is for its reader, not for the compiler.
struct SlangDirective {
    enum class Kind {
        include,
        include_optional,
        stage,
        name,
        format,
        parameter,
        line,  // #line, which would say that text comes from elsewhere
        damaged_include,
    };

    Kind kind = Kind::include;
    std::string_view argument;  // the path without its quotes; else all that follows, trimmed
    std::size_t begin = 0;      // of the line in the text
    std::size_t end = 0;        // past its '\n'
    int line = 0;               // from 1
};

/// The directives of a text whose lines all end with '\n'. They are found textually, whatever
/// `#if` they stand under. In a comment only those at the beginning of a line count, as RetroArch
/// reads them. The views point into `text`.
std::vector<SlangDirective> find_slang_directives(std::string_view text);
