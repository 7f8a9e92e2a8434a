#pragma once

#include "lab/match/unknown.h"
#include "model/look/look.h"

#include <string>
#include <vector>

/// A number that was found, in the order of the look.
struct FoundNumber {
    std::string parameter;
    std::size_t component = 0;
    double value = 0.0;
    double low = 0.0;  // 90 % interval, within the range of the slider
    double high = 0.0;
    std::string why_not;  // why it is not identifiable; "": it is
};

/// The numbers of the look among the unknowns. `covariance`: that of the unknowns, row by row. A
/// number is not identifiable if its interval is wider than half its value, or if its value is at
/// the end of its range.
std::vector<FoundNumber> found_numbers(const std::vector<Unknown>& unknowns,
                                       const MatchState& state,
                                       const std::vector<double>& covariance);
