#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The search in the compiled source.
struct SourceSearch {
    std::string text;
    std::size_t match = 0;  // the chosen one, from 0
    bool scrolls = false;   // to the chosen match, in the next frame

    bool operator==(const SourceSearch&) const = default;
};

/// A part of a text that matches a search.
struct SourceMatch {
    std::size_t line = 0;   // from 0
    std::size_t begin = 0;  // bytes in the line
    std::size_t end = 0;

    bool operator==(const SourceMatch&) const = default;
};

/// All matches in order, ignoring the case of ASCII letters; at most 10000. An empty text has none.
std::vector<SourceMatch> find_matches(const std::vector<std::string_view>& lines,
                                      std::string_view text);
