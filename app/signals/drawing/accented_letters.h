#pragma once

#include <optional>
#include <string_view>

/// A non-ASCII letter of the stroke font. Strokes are written as in stroke_font.cpp.
struct AccentedLetter {
    char base = 0;             // ASCII letter below the mark; 0: none
    std::string_view strokes;  // of a separate glyph; "": the base's
    std::string_view mark;     // strokes above or below the base; "": none
    bool is_mark_above = true;
    bool is_small = false;  // of a separate glyph
};

/// Letters of Latin-1 and Latin Extended-A and some signs; nullopt for others.
std::optional<AccentedLetter> find_accented_letter(char32_t letter);

/// The letter composed of a base and a combining mark, if the font has it.
std::optional<char32_t> composed_letter(char32_t base, char32_t combining);
