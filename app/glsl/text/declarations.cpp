#include "glsl/text/declarations.h"

#include "glsl/text/trailing_comments.h"

#include <algorithm>

namespace {
class Finder {
public:
    explicit Finder(std::string_view text) : m_tokens(scan(text).all) {}

    std::vector<Declaration> find() {
        int depth = 0;
        while (m_at < m_tokens.size()) {
            const Token& token = m_tokens[m_at];
            if (token.kind == Token::Kind::comment) {
                m_comments.add(token, token_before());
            } else if (!token.in_directive) {
                if (depth == 0 && token.is("uniform")) {
                    read_statement();
                    continue;
                }
                depth = std::max(depth + change_of_depth(token), 0);
            }
            ++m_at;
        }
        for (std::size_t i = 0; i < m_found.size(); ++i)
            m_found[i].comments = m_comments.of(i);
        return std::move(m_found);
    }

private:
    const Token* token_before() const { return m_at > 0 ? &m_tokens[m_at - 1] : nullptr; }

    static int change_of_depth(const Token& token) {
        if (token.is("(") || token.is("[") || token.is("{"))
            return 1;
        return token.is(")") || token.is("]") || token.is("}") ? -1 : 0;
    }

    // Reads from `uniform` to after its ';'.
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
        if (!m_has_started && m_comments.is_behind(token))
            m_comments.add(token, token_before());
        else if (depth == 0)
            m_current.comments.push_back(comment_from(token));
    }

    // Reads a token of the statement outside brackets.
    void read_token(const Token& token) {
        m_has_started = true;
        if (token.is("struct")) {
            m_is_struct = true;
        } else if (token.is("{") && !m_is_struct) {
            finish(token);
            m_is_done = true;  // a block; the name after it is the instance name
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
            m_comments.open(end.line, std::move(m_current.comments));
            m_found.push_back(std::move(m_current));
        }
        m_current = {};
    }

    std::vector<Token> m_tokens;
    std::vector<Declaration> m_found;
    std::size_t m_at = 0;

    // The current declarator.
    Declaration m_current;
    bool m_has_started = false;
    bool m_is_initialiser = false;
    bool m_is_struct = false;
    bool m_is_done = false;
    TrailingComments m_comments;
};
}  // namespace

std::vector<Declaration> find_declarations(std::string_view text) {
    return Finder(text).find();
}
