#pragma once

#include "gpu/context.h"

#include <cmath>
#include <optional>
#include <string>

namespace bench {

/// Whether a run counts in which a yardstick came to so many times itself.
inline bool is_itself(double ratio) {
    return std::abs(ratio - 1.0) <= 0.015;
}

/// What a figure is held to.
struct Bound {
    enum class Side { at_most, at_least };
    Side side = Side::at_most;
    double value = 0.0;
};
constexpr Bound at_most(double value) {
    return {Bound::Side::at_most, value};
}
constexpr Bound at_least(double value) {
    return {Bound::Side::at_least, value};
}

/// What several figures are about: a part of the table of docs/performance.md.
struct Topic {
    std::string key;
    std::string title;
};

/// One number that was measured.
struct Figure {
    std::string key;  // within its topic; the same whatever the words are
    std::string what;
    double value = 0.0;
    std::string unit = {};              // "": a ratio
    std::optional<Bound> bound = {};    // none: it is only told
    std::optional<double> itself = {};  // the ratio of the yardstick to itself
    std::optional<double> idle = {};    // the machine's share that was idle before
    std::string detail = {};            // what the number is made of
};

enum class Verdict { told, kept, missed, does_not_count };
Verdict verdict_of(const Figure& figure);

/// Prints a line for a person; adds one of JSON to the file that AFTERGLOW_BENCH_FIGURES names,
/// from which write_table.py makes the table. Ends the program where that file cannot be written,
/// or the value is no number.
void tell(const Topic& topic, const Figure& figure);

/// What draws, likewise.
void tell_driver(const gpu::Facts& facts);

}  // namespace bench
