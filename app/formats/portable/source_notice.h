#pragma once

#include <string>
#include <string_view>

/// Who wrote a source file, and under which licence, as far as its comments say so.
struct SourceNotice {
    std::string license;  // SPDX identifier, "see comments", or "not stated"
    std::string text;     // the comments about author and licence, without comment marks

    bool operator==(const SourceNotice&) const = default;
};

/// Reads the comments of a GLSL text that mention a licence, copyright or author. The identifier is
/// that of SPDX-License-Identifier (SPDX 2.3, annex E).
SourceNotice source_notice(std::string_view glsl);
