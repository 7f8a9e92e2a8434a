#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

/// A line of a .slang text for the shader loader, not for the compiler.
struct SlangDirective {
    enum class Kind {
        include,
        include_optional,
        stage,
        name,
        format,
        parameter,
        line,  // #line, which would change line numbers
        damaged_include,
    };

    Kind kind = Kind::include;
    std::string_view argument;  // the path without quotes; otherwise the rest of the line, trimmed
    std::size_t begin = 0;      // offset of the line in the text
    std::size_t end = 0;        // after its '\n'
    int line = 0;               // from 1
};

/// The directives of a text whose lines all end with '\n'. They are found textually, regardless of
/// `#if`. In a comment, only those at the start of a line count, as in RetroArch. The views point
/// into `text`.
std::vector<SlangDirective> find_slang_directives(std::string_view text);
