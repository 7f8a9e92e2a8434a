#pragma once

#include <map>
#include <set>
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

/// The words of a code, each once.
using GlslWords = std::set<std::string, std::less<>>;

/// Adds the words of the code of a text, comments apart.
void add_words(std::string_view text, GlslWords& words);

/// The #version line of a text with such words, and the extensions that functions of its need.
std::string modern_glsl_start(const GlslWords& words);
