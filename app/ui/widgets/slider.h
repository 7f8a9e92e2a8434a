#pragma once

#include "ui/widgets/typed_number.h"

#include <optional>
#include <string>
#include <vector>

/// What a slider runs over and how it shows its value.
struct SliderFacts {
    double low = 0.0;
    double high = 1.0;
    double step = 0.0;  // 0: any value
    bool is_logarithmic = false;
    std::optional<double> initial = {};  // gets a tick
    bool is_changed = false;
    std::string unit = {};
    std::optional<Limit> limit = {};  // of what is typed
    bool is_whole = false;
    std::optional<double> now = {};         // where it is while it moves by itself; gets a mark
    bool is_decay = false;                  // may be typed as a time
    std::optional<double> steps_from = {};  // where steps are counted from; none: the low end
    std::string note = {};                  // what the value comes to, on the bar where it fits
    std::string warning = {};               // about the value as it is; on hover
    std::vector<double> safe = {};          // values that are marked where they have room

    bool is_to_be_typed = false;  // its number has the keyboard from now on

    NumberFacts number() const {
        return {is_changed, unit, limit, is_whole, is_decay, is_to_be_typed};
    }
};

/// What a person just did to a control.
struct Turned {
    bool is_changed = false;
    bool is_finished = false;  // the hand let go; ends a step of undo

    Turned& operator|=(const Turned& other) {
        is_changed |= other.is_changed;
        is_finished |= other.is_finished;
        return *this;
    }
};

/// How a slider follows the hand: its place, or its way a tenth or ten times as far.
enum class DragPace { direct, fine, coarse };

/// Where the hand is on a slider after a way of `moved`, both in shares of its width; a direct hand
/// is where the pointer is.
double hand_after(double place, double moved, DragPace pace);

/// The value that a hand there asks for: a step, or a number that reads well, ten times finer or
/// coarser as the hand is.
double dragged_value(double place, const SliderFacts& facts, DragPace pace);

/// Where notches are drawn on a slider of that width in pixels, 0 .. 1, its ends left out: at its
/// steps, where all of them have room.
std::vector<double> notch_places(const SliderFacts& facts, double width);

/// Where the safe values are marked, likewise.
std::vector<double> safe_places(const SliderFacts& facts, double width);

/// A bar that follows the mouse (a tenth as far with Shift, ten times with Alt or Ctrl+Shift);
/// Ctrl+click or a double click types.
Turned draw_slider(const char* id, double& value, const SliderFacts& facts, float width);

/// The number itself, with its unit where that fits; a click types, also beyond the slider's
/// ends. What was typed is read when the field is left.
Turned draw_number(const char* id, double& value, float width, const NumberFacts& facts);

/// "0.1 to 16 px (typed: 0 to 64 px)".
std::string range_text(const SliderFacts& facts);

/// A number as a control shows it: about four digits, no needless zeros.
std::string short_number(double value);

/// Where a value lies on the slider, 0 low .. 1 high, and back. A logarithmic slider whose low end
/// is not above zero follows a cubic instead, which also gives small values the most room.
double slider_place(double value, const SliderFacts& facts);
double slider_value(double place, const SliderFacts& facts);
