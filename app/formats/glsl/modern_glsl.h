#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

/// Replacements of words; each replacement is a single line.
using WordChanges = std::map<std::string, std::string, std::less<>>;

/// The GLSL version of a text.
struct GlslVersion {
    int words = 330;    // desktop version with the same keywords; 100 for ES 1.00
    bool is_es = true;  // GL_ES is defined
};

/// From its #version; GLSL ES 1.00 without one.
GlslVersion glsl_version_of(std::string_view text);

/// Converts GLSL ES 1.00 or 3.00, or a desktop version, to GLSL 4.10, keeping line numbers.
/// Names in `version` that are keywords or functions in 4.10 are renamed. texture2D() and similar
/// functions become texture(); a variable or function named `texture` is renamed. Lines continued
/// by a backslash are joined, followed by empty lines. #version, #extension, #include and #line are
/// blanked out. GL_ES, which must not be defined, becomes afterglow_es. `changes` lists further
/// replacements.
std::string modern_glsl(std::string_view text, const WordChanges& changes = {},
                        GlslVersion version = {});

/// The set of words in code.
using GlslWords = std::set<std::string, std::less<>>;

/// Adds the words of a text's code, without comments.
void add_words(std::string_view text, GlslWords& words);

/// The first lines for a text with these words: #version, the extensions that its functions need,
/// and the replacement of GL_ES.
std::string modern_glsl_start(const GlslWords& words);
