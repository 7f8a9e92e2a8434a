#pragma once

#include "model/look/value.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

/// What the present picture is compared with.
struct Other {
    enum class Kind {
        article,  // the same look with every `as_written` turned
        slot,     // the same look with a slot's values
        file,     // a picture
    };

    Kind kind = Kind::article;
    std::size_t slot = 0;
    std::filesystem::path file = {};

    bool operator==(const Other&) const = default;
};

/// How two pictures are seen together.
enum class CompareMode { off, wipe, side_by_side, difference };

/// What a picture of a difference shows of two stored numbers a (ours) and b (the other).
enum class DifferenceMeasure {
    absolute,  // |a - b|
    relative,  // |a - b| / max(|b|, relative_floor)
    squared,   // (a - b)^2
};

/// Below this a number of the other picture counts as this large, or noise in the dark would be all
/// that a relative difference shows.
constexpr double relative_floor = 0.01;

double difference_of(double ours, double other, DifferenceMeasure measure);

/// What a person chose to compare with, and how.
struct Comparison {
    Other other = {};
    CompareMode mode = CompareMode::off;
    DifferenceMeasure measure = DifferenceMeasure::absolute;
    double gain_stops = 0.0;  // a difference is shown multiplied by two to this power
    bool has_equal_brightness = false;

    bool operator==(const Comparison&) const = default;
};

/// By how many stops the light of the other picture is to be multiplied so that its mean luminance
/// is ours. None where one of them has no light.
std::optional<double> matching_stops(double our_luminance, double other_luminance);

/// Values that a person keeps at hand.
struct Slot {
    std::string preset;  // that was open; "": none
    Values values;       // what differs from the defaults

    bool operator==(const Slot&) const = default;
};

/// A, B and C; none: empty.
using Slots = std::array<std::optional<Slot>, 3>;

/// "A".
std::string slot_name(std::size_t slot);

/// The slots of each look, or stack, by its id.
using LookSlots = std::map<std::string, Slots>;
