#pragma once

#include "base/diagnostic.h"

#include <memory>
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

/// Shared, as an include with hundreds of them may stand in every pass of a preset.
using SlangParameters = std::vector<std::shared_ptr<const SlangParameter>>;

/// The parameters in the order in which they are declared, each id once: the first one counts. One
/// that gives other numbers is a warning at its own place; "1.0" and "1.00" are the same.
SlangParameters unique_slang_parameters(const SlangParameters& declared, Diagnostics& warnings);
