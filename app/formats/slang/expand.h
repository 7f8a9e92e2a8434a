#pragma once

#include "formats/slang/files.h"

/// A piece of a shader's text after include expansion: consecutive lines of one file, or one
/// directive other than an include.
struct SlangPiece {
    const SlangText* text = nullptr;
    int first_line = 0;
    std::size_t line_count = 0;
    std::string_view lines = {};                // each with its '\n'
    const SlangDirective* directive = nullptr;  // null: lines for the compiler
};

/// `file` with all its includes, in order. Includes are textual: relative to the including file,
/// before any `#if`, and repeated each time. A missing `#pragma include_optional` is ignored.
/// Errors, several at once, are at the including line: a missing file, a circular include (with its
/// files), exceeded limits. Limits: 64 levels, 16,384 includes, 8 MiB in total. The pieces point
/// into `files`.
Result<std::vector<SlangPiece>> expand_slang(const std::filesystem::path& file, SlangFiles& files);
