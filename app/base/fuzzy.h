#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// How well a text matches a query, and which bytes match.
struct FuzzyMatch {
    int score = 0;                       // higher is better; 0 for an empty query
    std::vector<std::size_t> positions;  // matching bytes, ascending
};

/// Matches the words of `query` in `text`, each separately, in any order, ignoring case. A word
/// matches as a substring (two letters or more) or as letters in order. The first of these letters
/// must start a word ("spa" in "Save preset as"). Consecutive letters score highest, then letters
/// that start words. nullopt if a word does not match.
std::optional<FuzzyMatch> fuzzy_match(std::string_view query, std::string_view text);
