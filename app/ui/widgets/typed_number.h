#pragma once

#include "model/look/parameter.h"
#include "ui/widgets/typed_prefix.h"

#include <optional>
#include <string>
#include <string_view>

/// The accepted values of a number field and how it displays them.
struct NumberInfo {
    bool is_changed = false;
    std::string unit = {};
    std::optional<Limit> limit = {};  // typed values are limited to it
    bool is_whole = false;
    bool is_decay = false;     // accepts a time, see model/look/decay.h
    bool wants_focus = false;  // gets the keyboard focus
};

/// The result of parsing a typed number.
struct TypedNumber {
    std::optional<double> value;  // nullopt: not a number, the value is unchanged
    std::string complaint;        // "" if accepted unchanged
};

/// Parses a typed number: a decimal point or comma, and an optional unit. For a decay also a time,
/// see model/look/decay.h. "4,096" is rejected as ambiguous: 4.096 or 4096. An empty text changes
/// nothing.
TypedNumber read_typed_number(std::string_view text, const NumberInfo& info);

/// A text field that is open or has just been closed.
struct TypedField {
    unsigned id = 0;  // ImGui id; 0: no field
    int frame = 0;    // last frame that displayed it
    std::string text;
    std::string before;  // the text when the field opened
};

/// The state of a dragged slider.
struct SliderDrag {
    unsigned id = 0;     // of the slider
    double ratio = 0.0;  // unrounded position
};

/// Typed text and drags in progress. Stored as ImGui's user data; the toolkit owns it.
struct Typing {
    TypedField open;
    TypedField left;        // lost the focus, not parsed yet
    std::string complaint;  // about the last typed text, reported once
    SliderDrag drag;
    TypedPrefix list_item;  // of the open list
};

Typing& typing();
