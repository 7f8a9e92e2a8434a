#pragma once

#include "model/look/value.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

/// What the current picture is compared with.
struct Other {
    enum class Kind {
        article,  // the same look with every switch `as_written` on
        slot,     // the same look with a slot's values
        file,     // a picture
    };

    Kind kind = Kind::article;
    std::size_t slot = 0;
    std::filesystem::path file = {};

    bool operator==(const Other&) const = default;
};

/// How two pictures are displayed together.
enum class CompareMode { off, wipe, side_by_side, difference };

/// The value in a difference picture of two stored numbers a (ours) and b (the other).
enum class DifferenceMeasure {
    absolute,  // |a - b|
    relative,  // |a - b| / max(|b|, relative_floor)
    squared,   // (a - b)^2
};

/// A smaller number of the other picture counts as this large. Otherwise a relative difference
/// would show only noise in dark areas.
constexpr double relative_floor = 0.01;

double difference_of(double ours, double other, DifferenceMeasure measure);

/// The user's choice of comparison.
struct Comparison {
    Other other = {};
    CompareMode mode = CompareMode::off;
    DifferenceMeasure measure = DifferenceMeasure::absolute;
    double gain_stops = 0.0;  // a difference is shown multiplied by two to this power
    bool has_equal_brightness = false;

    bool operator==(const Comparison&) const = default;
};

/// The stops to multiply the other picture's light by, so that its mean luminance equals ours.
/// nullopt if either has no light.
std::optional<double> matching_stops(double our_luminance, double other_luminance);

/// Values that the user has stored in a slot.
struct Slot {
    std::string preset;  // the preset that was open; "" without one
    Values values;       // values that differ from the defaults

    bool operator==(const Slot&) const = default;
};

/// A, B and C; nullopt: empty.
using Slots = std::array<std::optional<Slot>, 3>;

/// "A".
std::string slot_name(std::size_t slot);

/// The slots of each look or stack, by its id.
using LookSlots = std::map<std::string, Slots>;
