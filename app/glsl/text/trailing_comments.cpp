#include "glsl/text/trailing_comments.h"

#include "base/text.h"

#include <algorithm>

namespace {
int last_line(const Token& token) {
    return token.line + static_cast<int>(std::ranges::count(token.text, '\n'));
}

constexpr std::size_t max_names_per_comment = 64;
}  // namespace

OpenString::OpenString(const std::vector<Comment>& comments) {
    for (const Comment& comment : comments)
        add(comment.text);
}

void OpenString::add(std::string_view comment) {
    for (std::size_t i = 0; i < comment.size(); ++i) {
        m_is_hint = m_is_hint || comment[i] == '@';
        if (m_is_open && comment[i] == '\\')
            ++i;
        else if (m_is_hint && comment[i] == '"')
            m_is_open = !m_is_open;
    }
}

Comment comment_from(const Token& token) {
    std::string_view text = token.text.substr(2);
    if (token.text.starts_with("/*") && text.ends_with("*/"))
        text.remove_suffix(2);
    return {std::string(text), token.line};
}

void TrailingComments::open(int line, std::vector<Comment> inside) {
    if (line != m_line || m_is_commented)
        m_open.clear();
    m_line = line;
    m_is_commented = !inside.empty();
    m_end = m_is_commented ? inside.back().line : 0;
    m_string = OpenString(inside);
    if (m_open.size() < max_names_per_comment)
        m_open.push_back(m_all.size());
    m_all.push_back(std::move(inside));
}

void TrailingComments::add(const Token& comment, const Token* before) {
    if (m_open.empty())
        return;
    if (!is_behind(comment) && !goes_on(comment, before))
        return m_open.clear();
    const Comment words = comment_from(comment);
    for (const std::size_t declaration : m_open)
        m_all[declaration].push_back(words);
    m_string.add(words.text);
    m_is_commented = true;
    m_end = last_line(comment);
}

bool TrailingComments::goes_on(const Token& comment, const Token* before) const {
    const bool is_alone = !before || last_line(*before) < comment.line;
    if (!m_is_commented || !is_alone || !comment.text.starts_with("//") ||
        comment.line != m_end + 1)
        return false;
    const std::string_view text = trim(comment.text.substr(2));
    return text.starts_with('@') || text.starts_with('"') || m_string.is_open();
}
