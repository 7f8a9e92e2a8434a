#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

/// Words of a text and what stands in their places; such text stays on its line.
using WordChanges = std::map<std::string, std::string, std::less<>>;

/// What a text is written in.
struct GlslVersion {
    int words = 330;    // the desktop version with the same keywords; of ES 1.00 that is 100
    bool is_es = true;  // GL_ES is defined
};

/// By its #version; without one it is GLSL ES 1.00.
GlslVersion glsl_version_of(std::string_view text);

/// GLSL ES 1.00 or 3.00, or a desktop version, in the words of GLSL 4.10, line by line: what
/// `version` has as names and 4.10 as keywords or functions gets other names; texture2D() and its
/// like become texture(); a variable or a function called `texture` makes way for them; lines that
/// a backslash joins are one, with empty ones behind it; #version, #extension, #include and #line
/// are blanked out; GL_ES, which no text may define, is afterglow_es. `changes` says what else is
/// replaced.
std::string modern_glsl(std::string_view text, const WordChanges& changes = {},
                        GlslVersion version = {});

/// The words of a code, each once.
using GlslWords = std::set<std::string, std::less<>>;

/// Adds the words of the code of a text, comments apart.
void add_words(std::string_view text, GlslWords& words);

/// The #version line of a text with such words, the extensions that functions of its need, and what
/// stands for GL_ES.
std::string modern_glsl_start(const GlslWords& words);
