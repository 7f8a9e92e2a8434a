#pragma once

#include <string>
#include <string_view>
#include <vector>

/// A comment and the line on which it starts.
struct Comment {
    std::string text;  // without // or /* */
    int line = 1;
};

/// A uniform declared in the text, whether or not the preprocessor removes it.
struct Declaration {
    std::string name;
    int line = 1;
    // After it on the same line, and // lines below that continue with hints. At most 64 names per
    // line share comments.
    std::vector<Comment> comments;
};

/// The uniforms of a text in order, found by scanning tokens. Handles several names per statement,
/// arrays, layout qualifiers, and uniform blocks (by block name).
std::vector<Declaration> find_declarations(std::string_view text);
