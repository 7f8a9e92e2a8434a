#pragma once

#include "base/diagnostic.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// A `#pragma parameter` as written; slang_controls() (controls.h) makes a control of it.
struct SlangParameter {
    std::string id;    // of the float that it drives; may not be a valid uniform name
    std::string text;  // UTF-8, with spaces, dashes and legend
    double initial = 0.0;
    double minimum = 0.0;  // may exceed maximum
    double maximum = 0.0;
    double step = 0.0;  // default: a tenth of the range
    Location declared;

    bool operator==(const SlangParameter&) const = default;
};

/// Parses the text after `#pragma parameter`: id "Text" initial minimum maximum [step].
Result<SlangParameter> parse_slang_parameter(std::string_view text, const Location& declared);

/// Shared, because an include with hundreds of them may occur in every pass of a preset.
using SlangParameters = std::vector<std::shared_ptr<const SlangParameter>>;

/// The parameters in order of declaration, each id once; the first one counts. A later one with
/// other numbers is a warning at its own location; "1.0" and "1.00" are equal.
SlangParameters unique_slang_parameters(const SlangParameters& declared, Diagnostics& warnings);
