#pragma once

#include "model/look/parameter.h"

#include <optional>
#include <string>
#include <string_view>

/// What a field for a number takes, and how it says it.
struct NumberFacts {
    bool is_changed = false;
    std::string unit = {};
    std::optional<Limit> limit = {};  // what is typed beyond it stops there
    bool is_whole = false;
    bool is_decay = false;        // may be typed as a time, see model/look/decay.h
    bool is_to_be_typed = false;  // has the keyboard from now on
};

/// What became of a text that was typed as a number.
struct TypedNumber {
    std::optional<double> value;  // none: the text was no number, the old value stays
    std::string complaint;        // "" when it was taken as it was typed
};

/// Reads what a person types: a point or a comma before the decimals, and the unit behind if they
/// like; for a decay also a time, see model/look/decay.h. "4,096" is refused: it may mean four or
/// four thousand. An empty text changes nothing.
TypedNumber read_typed_number(std::string_view text, const NumberFacts& facts);

/// A field that is, or a moment ago was, typed into.
struct TypedField {
    unsigned id = 0;  // of ImGui; 0: none
    int frame = 0;    // that last showed it
    std::string text;
    std::string before;  // as it was when the field opened
};

/// The hand that drags a slider.
struct SliderHand {
    unsigned id = 0;     // of the slider
    double place = 0.0;  // on it, not rounded to what the value stops at
};

/// What is being typed into numbers, and dragged. ImGui has it as its user data; the toolkit owns
/// it.
struct Typing {
    TypedField open;
    TypedField left;        // for another field, and not read yet
    std::string complaint;  // about what was typed last, to be said once
    SliderHand hand;
};
