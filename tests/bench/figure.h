#pragma once

#include "gpu/context.h"

#include <cmath>
#include <optional>
#include <string>

namespace bench {

/// Whether a run is valid, by the ratio of the reference to itself.
inline bool is_itself(double ratio) {
    return std::abs(ratio - 1.0) <= 0.015;
}

/// The target of a figure.
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

/// A group of figures: a table of docs/performance.md.
struct Topic {
    std::string key;
    std::string title;
};

/// A measured number.
struct Figure {
    std::string key;  // within its topic; stays the same if `what` is reworded
    std::string what;
    double value = 0.0;
    std::string unit = {};              // "": a ratio
    std::optional<Bound> bound = {};    // nullopt: reported only
    std::optional<double> itself = {};  // reference noise: the reference relative to itself
    std::optional<double> idle = {};    // idle share of the machine before the run
    std::string detail = {};            // the values behind the number
};

enum class Verdict { none, pass, miss, noise };
Verdict verdict_of(const Figure& figure);

/// Prints a line, and adds a line of JSON to the file named by AFTERGLOW_BENCH_FIGURES, from which
/// write_table.py makes the table. Ends the program if that file can't be written or the value is
/// not finite.
void tell(const Topic& topic, const Figure& figure);

/// Adds the driver to the same file.
void tell_driver(const gpu::DriverInfo& info);

}  // namespace bench
