#pragma once

#include "lab/document/document.h"

/// What is not the same in two states, in words: a line of a list.
struct Change {
    std::string name;    // of the parameter; "" for all else
    std::string label;   // "Decay", "Signal: Across"
    std::string before;  // "0.92", "#33ff4d", "Reinhard"
    std::string after;
    std::string unit;  // of both; "" for none

    bool operator==(const Change&) const = default;
};

/// What of `after` differs from `before`: the values in the order of the look's panel and then
/// those it does not know, signal, source, the looks of a stack and what was set of its passes. The
/// look is the one that is open, perhaps not yet the states'.
std::vector<Change> changes_between(const Look& look, const DocumentState& before,
                                    const DocumentState& after);

/// "Decay 0.92 → 0.61 per 1/60 s".
std::string line_of(const Change& change);

/// All of them in a few words: "0.92 → 0.61 per 1/60 s" where `step` says of what, else "Decay 0.92
/// → 0.61", and how many more there are; "" for none.
std::string summary_of(const std::vector<Change>& changes, const std::string& step);
