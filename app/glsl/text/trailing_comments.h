#pragma once

#include "glsl/text/declarations.h"
#include "glsl/text/tokens.h"

/// Tracks whether a string in a hint is still open at the end of the comments.
class OpenString {
public:
    OpenString() = default;
    explicit OpenString(const std::vector<Comment>& comments);

    void add(std::string_view comment);
    bool is_open() const { return m_is_open; }

private:
    bool m_is_hint = false;
    bool m_is_open = false;
};

/// Assigns comments to the declarations before them: on the same line, and in // lines below that
/// continue with hints. Up to 64 declarations on one line share the comments after the last one.
class TrailingComments {
public:
    /// The next declaration ends on `line`. `inside`: the comments within it.
    void open(int line, std::vector<Comment> inside);
    bool is_behind(const Token& comment) const { return comment.line == m_line; }
    /// Adds a comment outside declarations. `before`: the previous token, null at the start of the
    /// text.
    void add(const Token& comment, const Token* before);
    /// The comments of the n-th opened declaration, from 0.
    const std::vector<Comment>& of(std::size_t declaration) const { return m_all[declaration]; }

private:
    bool goes_on(const Token& comment, const Token* before) const;

    std::vector<std::vector<Comment>> m_all;
    std::vector<std::size_t> m_open;  // declarations on whose line a comment may still follow
    OpenString m_string;              // state of the last declaration's comments
    int m_line = 0;
    int m_end = 0;  // line on which the last comment ends
    bool m_is_commented = false;
};

/// The comment's text without // or /* */.
Comment comment_from(const Token& token);
