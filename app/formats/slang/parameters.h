#pragma once

#include "base/diagnostic.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What `#pragma parameter` says, as it says it; `slang_controls` (legend.h) makes of it what a
/// person turns.
struct SlangParameter {
    std::string id;    // of the float that it drives; not always one that a uniform could have
    std::string text;  // UTF-8, with its blanks, dashes and legend
    double initial = 0.0;
    double minimum = 0.0;  // may be above maximum
    double maximum = 0.0;
    double step = 0.0;  // a tenth of the range where none is said
    Location declared;

    bool operator==(const SlangParameter&) const = default;
};

/// Reads what follows `#pragma parameter`: id "Text" initial minimum maximum [step].
Result<SlangParameter> parse_slang_parameter(std::string_view text, const Location& declared);

/// The parameters of several shaders, or of several lines of one, each id once: the first
/// declaration counts. One that gives other numbers is a warning at its own place; "1.0" and "1.00"
/// are the same. More than 1,024 are an error.
Result<std::vector<SlangParameter>> unique_slang_parameters(
    std::span<const SlangParameter> declared, Diagnostics& warnings);
