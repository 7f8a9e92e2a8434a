#include "glsl/declarations.h"

#include "base/text.h"
#include "glsl/tokens.h"

#include <algorithm>

namespace {
Comment comment_from(const Token& token) {
    std::string_view text = token.text.substr(2);
    if (token.text.starts_with("/*") && text.ends_with("*/"))
        text.remove_suffix(2);
    return {std::string(text), token.line};
}

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

class Finder {
public:
    explicit Finder(std::string_view text) : m_tokens(scan(text).all) {}

    std::vector<Declaration> find() {
        int depth = 0;
        while (m_at < m_tokens.size()) {
            const Token& token = m_tokens[m_at];
            if (token.kind == Token::Kind::comment) {
                add_comment_behind(token);
            } else if (!token.in_directive) {
                if (depth == 0 && token.is("uniform")) {
                    read_statement();
                    continue;
                }
                depth = std::max(depth + change_of_depth(token), 0);
            }
            ++m_at;
        }
        return std::move(m_found);
    }

private:
    static int change_of_depth(const Token& token) {
        if (token.is("(") || token.is("[") || token.is("{"))
            return 1;
        return token.is(")") || token.is("]") || token.is("}") ? -1 : 0;
    }

    // From `uniform` to behind its ';'.
    void read_statement() {
        m_current = {};
        m_has_started = true;
        m_is_initialiser = m_is_struct = m_is_done = false;
        int depth = 0;
        for (++m_at; m_at < m_tokens.size(); ++m_at) {
            const Token& token = m_tokens[m_at];
            if (token.kind == Token::Kind::comment) {
                read_comment(token, depth);
                continue;
            }
            if (token.in_directive)
                continue;
            if (depth == 0 && token.is("uniform"))
                return;
            if (depth == 0)
                read_token(token);
            depth = std::max(depth + change_of_depth(token), 0);
            if (depth == 0 && token.is(";")) {
                ++m_at;
                return;
            }
        }
    }

    void read_comment(const Token& token, int depth) {
        if (!m_has_started && token.line == m_open_line)
            add_comment_behind(token);
        else if (depth == 0)
            m_current.comments.push_back(comment_from(token));
    }

    // A token of the statement that stands in no bracket.
    void read_token(const Token& token) {
        m_has_started = true;
        if (token.is("struct")) {
            m_is_struct = true;
        } else if (token.is("{") && !m_is_struct) {
            finish(token);
            m_is_done = true;  // a block; the name behind it is not a uniform's
        } else if (token.is(",") || token.is(";")) {
            finish(token);
            m_is_initialiser = false;
            m_has_started = false;
        } else if (token.is("=")) {
            m_is_initialiser = true;
        } else if (token.kind == Token::Kind::word && !m_is_initialiser) {
            m_current.name = token.text;
            m_current.line = token.line;
        }
    }

    void finish(const Token& end) {
        if (!m_is_done && !m_current.name.empty()) {
            if (end.line != m_open_line || m_is_commented)
                m_open.clear();
            m_open_line = end.line;
            m_is_commented = !m_current.comments.empty();
            m_comment_end = m_is_commented ? m_current.comments.back().line : 0;
            m_open.push_back(m_found.size());
            m_found.push_back(std::move(m_current));
        }
        m_current = {};
    }

    // A comment behind a declaration on its line, or a // line that goes on with its hints.
    void add_comment_behind(const Token& token) {
        if (m_open.empty())
            return;
        const bool is_behind = token.line == m_open_line;
        if (!is_behind && !goes_on(token))
            return m_open.clear();
        for (const std::size_t index : m_open)
            m_found[index].comments.push_back(comment_from(token));
        m_is_commented = true;
        m_comment_end = last_line(token);
    }

    bool goes_on(const Token& token) const {
        const bool is_alone = m_at == 0 || last_line(m_tokens[m_at - 1]) < token.line;
        if (!m_is_commented || !is_alone || !token.text.starts_with("//") ||
            token.line != m_comment_end + 1)
            return false;
        const std::string_view text = trim(token.text.substr(2));
        return text.starts_with('@') || text.starts_with('"') ||
               has_open_string(m_found[m_open.back()].comments);
    }

    std::vector<Token> m_tokens;
    std::vector<Declaration> m_found;
    std::size_t m_at = 0;

    // The declarator that is being read.
    Declaration m_current;
    bool m_has_started = false;
    bool m_is_initialiser = false;
    bool m_is_struct = false;
    bool m_is_done = false;

    // Those whose line may still bring a comment.
    std::vector<std::size_t> m_open;
    int m_open_line = 0;
    int m_comment_end = 0;
    bool m_is_commented = false;
};
}  // namespace

std::vector<Declaration> find_declarations(std::string_view text) {
    return Finder(text).find();
}
