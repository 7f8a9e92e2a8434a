#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// How well a text fits what was typed, and by which of its bytes.
struct FuzzyMatch {
    int score = 0;                    // the higher the better; 0 for an empty query
    std::vector<std::size_t> places;  // that fit, rising
};

/// Fits the words of `query` into `text`, each on its own and in any order, whatever the case: a
/// word is a piece of the text (of two letters or more), or letters in order of which the first
/// begins a word ("spa" in "Save preset as"). Letters that follow one another count most, then
/// those that begin words. Nothing when a word does not fit.
std::optional<FuzzyMatch> fuzzy_match(std::string_view query, std::string_view text);
