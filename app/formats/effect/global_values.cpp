#include "formats/effect/global_values.h"

#include "formats/effect/effect_text.h"
#include "glsl/text/interface_statements.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace {
using Part = std::span<const Token>;

// The tokens of code, without directives and comments.
std::vector<Token> code_of(const Tokens& tokens) {
    std::vector<Token> code;
    for (const Token& token : tokens.all)
        if (!token.in_directive && token.kind != Token::Kind::comment)
            code.push_back(token);
    return code;
}

int depth_change(const Token& token) {
    const bool opens = token.is("(") || token.is("[") || token.is("{");
    const bool closes = token.is(")") || token.is("]") || token.is("}");
    return (opens ? 1 : 0) - (closes ? 1 : 0);
}

// The first token that is `wanted` outside of brackets; the size of the part if there is none.
std::size_t find_outside(Part part, std::string_view wanted) {
    int depth = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
        if (depth == 0 && part[i].is(wanted))
            return i;
        depth += depth_change(part[i]);
    }
    return part.size();
}

// A statement at global scope: to its ';', or to the end of a function.
std::size_t statement_size(Part code) {
    int depth = 0;
    bool has_value = false;
    for (std::size_t i = 0; i < code.size(); ++i) {
        depth += depth_change(code[i]);
        has_value = has_value || (depth == 0 && code[i].is("="));
        if (depth <= 0 && (code[i].is(";") || (code[i].is("}") && !has_value)))
            return i + 1;
    }
    return code.size();
}

/// Works through the statements of a text in order.
class Taker {
public:
    Taker(std::string& text, std::set<std::string, std::less<>> late)
        : m_text(text), m_late(std::move(late)) {}

    std::string take() {
        const std::string before = m_text;
        const Tokens tokens = scan(before);
        m_begin = before.data();
        for (const Directive& directive : find_directives(before, tokens))
            if (directive.name == "define" && is_late(directive.arguments))
                m_late.emplace(directive.arguments.front().text);
        const std::vector<Token> code = code_of(tokens);
        for (Part left = code; !left.empty();) {
            const std::size_t size = statement_size(left);
            if (const Part statement = left.first(size); is_late(statement))
                read(statement);
            left = left.subspan(size);
        }
        return m_settings;
    }

private:
    bool is_late(Part part) const {
        return std::ranges::any_of(part,
                                   [&](const Token& token) { return m_late.contains(token.text); });
    }

    void read(Part statement) {
        if (find_outside(statement, "=") < statement.size())
            return take_values(statement);
        const std::size_t bracket = find_outside(statement, "(");
        if (bracket > 0 && bracket < statement.size())
            m_late.emplace(statement[bracket - 1].text);  // a function
    }

    void take_values(Part statement) {
        if (statement.front().is("const"))
            blank_out(statement.front(), statement.front());
        for (Part left = statement; !left.empty();) {
            const std::size_t size = std::min(find_outside(left, ","), find_outside(left, ";"));
            take_value(left.first(size));
            left = left.subspan(std::min(size + 1, left.size()));
        }
    }

    // `part`: "float a[2] = value" or "a = value".
    void take_value(Part part) {
        const std::size_t equals = find_outside(part, "=");
        if (equals == 0 || equals + 1 >= part.size())
            return;
        const std::size_t size = find_outside(part.first(equals), "[");
        const std::string_view name = part[std::min(size, equals) - 1].text;
        const Token& last = part.back();
        const char* const begin = part[equals + 1].text.data();
        m_settings += fmt::format(
            "    {} = {};\n", name,
            std::string_view(
                begin, static_cast<std::size_t>(last.text.data() + last.text.size() - begin)));
        blank_out(part[equals], last);
        m_late.emplace(name);
    }

    void blank_out(const Token& first, const Token& last) {
        const auto offset = [&](const Token& token) {
            return static_cast<std::size_t>(token.text.data() - m_begin);
        };
        ::blank_out(m_text, offset(first), offset(last) + last.text.size());
    }

    std::string& m_text;
    const char* m_begin = nullptr;  // of the text that the tokens are from
    std::set<std::string, std::less<>> m_late;
    std::string m_settings;
};
}  // namespace

void add_input_names(std::string_view shader, const WordChanges& words,
                     std::set<std::string, std::less<>>& names) {
    for (const InterfaceStatement& statement : find_interface_statements(shader))
        if (statement.kind == InterfaceStatement::Kind::input)
            for (const Declarator& input : statement.declarators)
                names.insert(renamed_word(words, input.name));
}

std::string take_late_values(std::string& text, std::set<std::string, std::less<>> late) {
    return Taker(text, std::move(late)).take();
}
