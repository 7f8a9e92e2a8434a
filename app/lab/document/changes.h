#pragma once

#include "lab/document/document.h"

/// A difference between two states, as the texts of one line in a list.
struct Change {
    std::string name;    // of the parameter; "": not a parameter
    std::string label;   // "Decay", "Signal: Across"
    std::string before;  // "0.92", "#33ff4d", "Reinhard"
    std::string after;
    std::string unit;  // of both; "": no unit

    bool operator==(const Change&) const = default;
};

/// The differences between `before` and `after`: values in the order of the panel, then unknown
/// ones, then modulations, signal, source, stack and pass overrides. `look` is the open look, which
/// may not match the states yet.
std::vector<Change> changes_between(const Look& look, const DocumentState& before,
                                    const DocumentState& after);

/// "Decay 0.92 → 0.61 per 1/60 s".
std::string line_of(const Change& change);

/// A short summary: "0.92 → 0.61 per 1/60 s" if `step` contains the label, otherwise "Decay 0.92 →
/// 0.61". Also the number of further changes. "": no changes.
std::string summary_of(const std::vector<Change>& changes, const std::string& step);
