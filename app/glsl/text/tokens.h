#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// A piece of GLSL as it is written, comments included; a view into the text that was scanned.
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
    int unclosed_comment = 0;  // line where a block comment starts that never ends; 0: none
};

/// Cuts a text into tokens; never fails. Punctuation is one character a token. Strings exist only
/// in directives (GLSL has none). `text` must outlive the tokens.
Tokens scan(std::string_view text);

/// A preprocessor line: `#name`, then its tokens without comments.
struct Directive {
    std::string_view name;  // "" for a lone '#'
    std::vector<Token> arguments;
    int line = 1;
    std::size_t begin = 0;  // offset of the '#'
    std::size_t end = 0;    // offset behind the last argument
};

/// The directives of `text`, which `tokens` were scanned from.
std::vector<Directive> find_directives(std::string_view text, const Tokens& tokens);

/// The text with every `#line` blanked out: it would make compilers count lines from elsewhere.
std::string without_line_directives(std::string text);

/// Overwrites a directive with blanks; line ends stay.
void blank_out(std::string& text, std::size_t begin, std::size_t end);
