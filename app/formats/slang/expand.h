#pragma once

#include "formats/slang/files.h"

/// A piece of a shader's text after its includes: lines that follow each other in one file, or one
/// directive that is no include.
struct SlangPiece {
    const SlangText* text = nullptr;
    int first_line = 0;
    std::size_t line_count = 0;
    std::string_view lines = {};                // each with its '\n'
    const SlangDirective* directive = nullptr;  // none: lines for the compiler
};

/// `file` with everything that it includes, in order. Includes are textual: relative to the
/// including file, before any `#if`, each time that they are asked for. What `#pragma
/// include_optional` does not find is left out. An error stands at the including line: a missing
/// file, a circle (told with its files), more than 64 deep, more than 16,384 includes or 8 MiB in
/// all; several at once. The pieces point into `files`.
Result<std::vector<SlangPiece>> expand_slang(const std::filesystem::path& file, SlangFiles& files);
