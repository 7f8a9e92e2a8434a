#pragma once

#include <string>
#include <string_view>
#include <vector>

/// A comment and the line of the text that it starts on.
struct Comment {
    std::string text;  // without // or /* */
    int line = 1;
};

/// A uniform as a text declares it, whether or not the preprocessor lets it through.
struct Declaration {
    std::string name;
    int line = 1;
    // Behind it on its line, and the // lines that go on with hints; of at most 64 names a line.
    std::vector<Comment> comments;
};

/// The uniforms of a text in order, found by their tokens: several in one statement, arrays, layout
/// qualifiers and uniform blocks (by the block's name) included.
std::vector<Declaration> find_declarations(std::string_view text);
