#pragma once

#include <optional>
#include <string_view>

/// A letter beyond ASCII as the stroke font draws it. Strokes are written as in stroke_font.cpp.
struct MarkedLetter {
    char base = 0;             // a letter of ASCII with a mark; 0: none
    std::string_view strokes;  // of a letter of its own; "": the base's
    std::string_view mark;     // strokes above or below the base; "": none
    bool is_mark_above = true;
    bool is_small = false;  // of a letter of its own
};

/// Letters of Latin-1 and Latin Extended-A and some signs; nothing for all others.
std::optional<MarkedLetter> find_marked_letter(char32_t letter);

/// The letter that a base and a combining mark of Unicode make, of those that are known here.
std::optional<char32_t> composed_letter(char32_t base, char32_t combining);
