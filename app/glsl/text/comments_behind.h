#pragma once

#include "glsl/text/declarations.h"
#include "glsl/text/tokens.h"

/// Whether a string of a hint is still open where the comments so far end.
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

/// Gives comments to the declarations that they stand behind: on its line, and in the // lines
/// below that go on with hints. Several declarations on one line, up to 64, share what stands
/// behind the last.
class CommentsBehind {
public:
    /// The next declaration ends on `line`; `inside` are the comments within it.
    void open(int line, std::vector<Comment> inside);
    bool is_behind(const Token& comment) const { return comment.line == m_line; }
    /// A comment outside of declarations; `before`: the token before it, null at the text's start.
    void add(const Token& comment, const Token* before);
    /// Of the declaration that was opened as the n-th, from 0.
    const std::vector<Comment>& of(std::size_t declaration) const { return m_all[declaration]; }

private:
    bool goes_on(const Token& comment, const Token* before) const;

    std::vector<std::vector<Comment>> m_all;
    std::vector<std::size_t> m_open;  // those whose line may still bring a comment
    OpenString m_string;              // of the last one's comments
    int m_line = 0;
    int m_end = 0;  // line where the last comment ends
    bool m_is_commented = false;
};

/// What the token says, without // or /* */.
Comment comment_from(const Token& token);
