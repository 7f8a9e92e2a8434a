#include "glsl/comments_behind.h"

#include "base/text.h"

#include <algorithm>

namespace {
int last_line(const Token& token) {
    return token.line + static_cast<int>(std::ranges::count(token.text, '\n'));
}

// Whether a string of a hint is still open where the comments end.
bool has_open_string(const std::vector<Comment>& comments) {
    bool is_hint = false;
    bool is_open = false;
    for (const Comment& comment : comments)
        for (std::size_t i = 0; i < comment.text.size(); ++i) {
            const char c = comment.text[i];
            is_hint = is_hint || c == '@';
            if (is_open && c == '\\')
                ++i;
            else if (is_hint && c == '"')
                is_open = !is_open;
        }
    return is_open;
}
}  // namespace

Comment comment_from(const Token& token) {
    std::string_view text = token.text.substr(2);
    if (token.text.starts_with("/*") && text.ends_with("*/"))
        text.remove_suffix(2);
    return {std::string(text), token.line};
}

void CommentsBehind::open(int line, std::vector<Comment> inside) {
    if (line != m_line || m_is_commented)
        m_open.clear();
    m_line = line;
    m_is_commented = !inside.empty();
    m_end = m_is_commented ? inside.back().line : 0;
    m_open.push_back(m_all.size());
    m_all.push_back(std::move(inside));
}

void CommentsBehind::add(const Token& comment, const Token* before) {
    if (m_open.empty())
        return;
    if (!is_behind(comment) && !goes_on(comment, before))
        return m_open.clear();
    for (const std::size_t declaration : m_open)
        m_all[declaration].push_back(comment_from(comment));
    m_is_commented = true;
    m_end = last_line(comment);
}

bool CommentsBehind::goes_on(const Token& comment, const Token* before) const {
    const bool is_alone = !before || last_line(*before) < comment.line;
    if (!m_is_commented || !is_alone || !comment.text.starts_with("//") ||
        comment.line != m_end + 1)
        return false;
    const std::string_view text = trim(comment.text.substr(2));
    return text.starts_with('@') || text.starts_with('"') || has_open_string(m_all[m_open.back()]);
}
