#include "glsl/text/tokens.h"

#include <algorithm>

namespace {
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool starts_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

class Scanner {
public:
    explicit Scanner(std::string_view text) : m_text(text) {}

    Tokens scan() {
        while (m_at < m_text.size())
            step();
        return std::move(m_tokens);
    }

private:
    char peek(std::size_t ahead = 0) const {
        return m_at + ahead < m_text.size() ? m_text[m_at + ahead] : '\0';
    }

    void step() {
        const char c = peek();
        if (c == '\n')
            end_line();
        else if (c == '\\' && peek(1) == '\n')
            continue_line();
        else if (c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v')
            ++m_at;
        else if (c == '/' && peek(1) == '/')
            add(Token::Kind::comment, std::min(m_text.find('\n', m_at), m_text.size()));
        else if (c == '/' && peek(1) == '*')
            add_block_comment();
        else
            add_code();
    }

    void end_line() {
        ++m_at;
        ++m_line;
        m_in_directive = false;
        m_line_has_code = false;
    }

    void continue_line() {
        m_at += 2;
        ++m_line;
    }

    void add_code() {
        const char c = peek();
        const bool starts_directive = c == '#' && !m_line_has_code;
        m_in_directive = m_in_directive || starts_directive;
        m_line_has_code = true;
        if (starts_word(c))
            add(Token::Kind::word, end_of_word());
        else if (is_digit(c) || (c == '.' && is_digit(peek(1))))
            add(Token::Kind::number, end_of_number());
        else if (c == '"' && m_in_directive && end_of_string() != std::string_view::npos)
            add(Token::Kind::string, end_of_string());
        else
            add(Token::Kind::punctuation, m_at + 1);
        m_tokens.all.back().starts_directive = starts_directive;
    }

    void add_block_comment() {
        const std::size_t close = m_text.find("*/", m_at + 2);
        if (close == std::string_view::npos)
            m_tokens.unclosed_comment = m_line;
        add(Token::Kind::comment, close == std::string_view::npos ? m_text.size() : close + 2);
    }

    std::size_t end_of_word() const {
        std::size_t end = m_at;
        while (end < m_text.size() && (starts_word(m_text[end]) || is_digit(m_text[end])))
            ++end;
        return end;
    }

    std::size_t end_of_number() const {
        std::size_t end = m_at;
        while (end < m_text.size()) {
            const char c = m_text[end];
            const bool is_sign = (c == '+' || c == '-') && end > m_at &&
                                 (m_text[end - 1] == 'e' || m_text[end - 1] == 'E');
            if (!starts_word(c) && !is_digit(c) && c != '.' && !is_sign)
                break;
            ++end;
        }
        return end;
    }

    std::size_t end_of_string() const {
        const std::size_t close = m_text.find_first_of("\"\n", m_at + 1);
        const bool is_closed = close != std::string_view::npos && m_text[close] == '"';
        return is_closed ? close + 1 : std::string_view::npos;
    }

    void add(Token::Kind kind, std::size_t end) {
        const std::string_view piece = m_text.substr(m_at, end - m_at);
        m_tokens.all.push_back({kind, piece, m_line, m_in_directive});
        m_line += static_cast<int>(std::count(piece.begin(), piece.end(), '\n'));
        m_at = end;
    }

    std::string_view m_text;
    Tokens m_tokens;
    std::size_t m_at = 0;
    int m_line = 1;
    bool m_in_directive = false;
    bool m_line_has_code = false;
};
}  // namespace

Tokens scan(std::string_view text) {
    return Scanner(text).scan();
}

std::vector<Directive> find_directives(std::string_view text, const Tokens& tokens) {
    std::vector<Directive> directives;
    for (const Token& token : tokens.all) {
        if (!token.in_directive || token.kind == Token::Kind::comment)
            continue;
        const auto begin = static_cast<std::size_t>(token.text.data() - text.data());
        if (token.starts_directive)
            directives.push_back({{}, {}, token.line, begin, begin});
        Directive& directive = directives.back();
        directive.end = begin + token.text.size();
        if (!token.starts_directive && directive.name.empty())
            directive.name = token.text;
        else if (!token.starts_directive)
            directive.arguments.push_back(token);
    }
    return directives;
}

void blank_out(std::string& text, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
        if (text[i] != '\n' && text[i] != '\\')
            text[i] = ' ';
}

std::string without_line_directives(std::string text) {
    if (text.find("line") == std::string::npos)
        return text;
    const Tokens tokens = scan(text);
    for (const Directive& directive : find_directives(text, tokens))
        if (directive.name == "line")
            blank_out(text, directive.begin, directive.end);
    return text;
}
