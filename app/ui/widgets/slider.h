#pragma once

#include "ui/widgets/typed_number.h"

#include <optional>
#include <string>
#include <vector>

/// The range of a slider and its display options.
struct SliderInfo {
    double low = 0.0;
    double high = 1.0;
    double step = 0.0;  // 0: any value
    Scale scale = Scale::linear;
    std::optional<double> initial = {};  // marked by a tick
    bool is_changed = false;
    std::string unit = {};
    std::optional<Limit> limit = {};  // of typed values
    bool is_whole = false;
    std::optional<double> now = {};         // the modulated value, marked by a line
    bool is_decay = false;                  // can be typed as a time
    std::optional<double> steps_from = {};  // origin of the steps; nullopt: the low end
    std::string note = {};                  // drawn on the bar if it fits
    std::string warning = {};               // about the current value, as a tooltip
    std::vector<double> safe = {};          // marked if they fit

    bool wants_focus = false;  // focuses its number field
};

/// Those of its number field.
inline NumberInfo number_info(const SliderInfo& info) {
    return {info.is_changed, info.unit, info.limit, info.is_whole, info.is_decay, info.wants_focus};
}

/// The user's change of a control in this frame.
struct ValueEdit {
    bool is_changed = false;
    bool is_finished = false;  // released; ends an undo step

    ValueEdit& operator|=(const ValueEdit& other) {
        is_changed |= other.is_changed;
        is_finished |= other.is_finished;
        return *this;
    }
};

/// Drag mode: the pointer's position, or its movement scaled by 0.1 or 10.
enum class DragPace { direct, fine, coarse };

/// The position on the slider after a pointer movement of `moved`, both relative to its width. In
/// direct mode the position is that of the pointer.
double dragged_share(double ratio, double moved, DragPace pace);

/// The value at a position: the nearest step, or a readable number whose resolution depends on the
/// drag mode.
double dragged_value(double ratio, const SliderInfo& info, DragPace pace);

/// Positions of the notches on a slider of this width in pixels, 0 to 1, without its ends. One per
/// step; empty if the steps are too close together.
std::vector<double> notch_ratios(const SliderInfo& info, double width);

/// Positions of the safe values that fit, 0 to 1.
std::vector<double> safe_ratios(const SliderInfo& info, double width);

/// A bar that is dragged with the mouse; Shift scales the movement by 0.1, Alt or Ctrl+Shift by 10.
/// Ctrl+click or double-click to type a value.
ValueEdit draw_slider(const char* id, double& value, const SliderInfo& info, float width);

/// The number with its unit, if it fits. Click to type a value, which can be beyond the slider's
/// ends. The text is parsed when the field loses the focus.
ValueEdit draw_number(const char* id, double& value, float width, const NumberInfo& info);

/// "0.1 to 16 px (typed: 0 to 64 px)".
std::string range_text(const SliderInfo& info);

/// A number as in controls: about four digits, without trailing zeros.
std::string short_number(double value);

/// Converts a value to its slider position, 0 (low) to 1 (high), and back. A logarithmic slider
/// with a low end at or below zero is cubic instead, with the most space for small values.
double slider_ratio(double value, const SliderInfo& info);
double slider_value(double ratio, const SliderInfo& info);
