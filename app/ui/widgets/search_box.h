#pragma once

#include "ui/frame/edits.h"

#include <string>

/// The options of a search box.
struct SearchBox {
    const char* mark;  // of the text field, for window tests; its button has the suffix "_clear"
    const char* hint;
    float width;
    bool wants_focus = false;
    bool* is_entered = nullptr;  // set when Enter is pressed; the field keeps the focus
};

/// A text field with a button that clears it. Escape clears the text. Without a text, Escape leaves
/// the field. Returns whether the text changed.
bool draw_search_box(const SearchBox& box, std::string& text, Edits& edits);
