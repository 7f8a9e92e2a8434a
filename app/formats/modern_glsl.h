#pragma once

#include <map>
#include <string>
#include <string_view>

/// Words of a text and what stands in their places; such text stays on its line.
using WordChanges = std::map<std::string, std::string, std::less<>>;

/// GLSL ES 1.00 or 3.00, or an old desktop version, in the words of GLSL 4.10, line by line: what
/// ES has as names and 4.10 as keywords or functions gets other names; texture2D() and its like
/// become texture(); a variable called `texture` makes way for them; lines that a backslash joins
/// are one, with empty ones behind it; #version, #extension and #line are blanked out. `changes`
/// says what else is replaced.
std::string modern_glsl(std::string_view text, const WordChanges& changes = {});

/// The #version line of such a text, and the extensions that functions of its need.
std::string modern_glsl_start(std::string_view text);

/// Whether a word stands in the code of a text, comments apart.
bool has_word(std::string_view text, std::string_view word);
