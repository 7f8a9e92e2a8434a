#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// A token of GLSL source text, including comments; a view into the scanned text.
struct Token {
    enum class Kind { word, number, punctuation, string, comment };

    Kind kind = Kind::punctuation;
    std::string_view text;
    int line = 1;
    bool in_directive = false;
    bool starts_directive = false;

    bool is(std::string_view wanted) const { return text == wanted; }
};

struct Tokens {
    std::vector<Token> all;
    int unclosed_comment = 0;  // line where an unterminated block comment starts; 0: none
};

/// Splits a text into tokens; never fails. Each punctuation character is a token. Strings occur
/// only in directives (GLSL has none). `text` must outlive the tokens.
Tokens scan(std::string_view text);

/// A preprocessor line: `#name` and its tokens without comments.
struct Directive {
    std::string_view name;  // "" for a lone '#'
    std::vector<Token> arguments;
    int line = 1;
    std::size_t begin = 0;  // offset of the '#'
    std::size_t end = 0;    // offset after the last argument
};

/// The directives of `text`. `tokens` must be scanned from it.
std::vector<Directive> find_directives(std::string_view text, const Tokens& tokens);

/// The text with each `#line` blanked out, because it would change the compiler's line numbers.
std::string without_line_directives(std::string text);

/// Overwrites a directive with spaces; line ends stay.
void blank_out(std::string& text, std::size_t begin, std::size_t end);
