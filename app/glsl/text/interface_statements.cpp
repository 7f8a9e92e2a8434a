#include "glsl/text/interface_statements.h"

#include "base/text.h"
#include "glsl/text/tokens.h"

#include <algorithm>
#include <array>
#include <optional>

namespace {
using Kind = InterfaceStatement::Kind;

constexpr auto qualifiers = std::to_array<std::string_view>(
    {"uniform", "in", "out", "varying", "attribute", "flat", "smooth", "noperspective", "centroid",
     "invariant", "precise", "highp", "mediump", "lowp", "const"});

int change_of_depth(const Token& token) {
    if (token.is("(") || token.is("[") || token.is("{"))
        return 1;
    return token.is(")") || token.is("]") || token.is("}") ? -1 : 0;
}

/// The code of a text without comments and directives, as statements at global scope.
class GlobalCode {
public:
    explicit GlobalCode(std::string_view text) : m_text(text) {
        for (const Token& token : scan(text).all)
            if (token.kind != Token::Kind::comment && !token.in_directive)
                m_tokens.push_back(token);
    }

    const Token& operator[](std::size_t at) const { return m_tokens[at]; }
    std::size_t size() const { return m_tokens.size(); }
    bool is(std::size_t at, std::string_view word) const {
        return at < size() && m_tokens[at].is(word);
    }
    bool is_word(std::size_t at) const {
        return at < size() && m_tokens[at].kind == Token::Kind::word;
    }
    std::size_t begin_of(std::size_t at) const {
        return static_cast<std::size_t>(m_tokens[at].text.data() - m_text.data());
    }
    std::size_t end_of(std::size_t at) const { return begin_of(at) + m_tokens[at].text.size(); }
    std::string text_of(std::size_t first, std::size_t end) const {
        return first < end
                   ? std::string(m_text.substr(begin_of(first), end_of(end - 1) - begin_of(first)))
                   : std::string();
    }

    // The token after the bracket that closes the one at `at`.
    std::size_t after_bracket(std::size_t at) const {
        int depth = 0;
        for (; at < size(); ++at) {
            depth += change_of_depth(m_tokens[at]);
            if (depth <= 0)
                return at + 1;
        }
        return at;
    }

    // The token after a statement: its ';', or the body of a function.
    std::size_t after_statement(std::size_t at) const {
        while (at < size() && !is(at, ";")) {
            if (is(at, "{")) {
                at = after_bracket(at);
                if (!is_word(at) && !is(at, ";"))
                    return at;
                // a name after the members of a block or struct, or the next statement
                if (!is(at + 1, ";") && !is(at + 1, "[") && !is(at + 1, ",") && !is(at, ";"))
                    return at;
                continue;
            }
            at = is(at, "(") || is(at, "[") ? after_bracket(at) : at + 1;
        }
        return std::min(at + 1, size());
    }

private:
    std::string_view m_text;
    std::vector<Token> m_tokens;
};

// From after a type to the ';'.
std::vector<Declarator> declarators_in(const GlobalCode& code, std::size_t at) {
    std::vector<Declarator> all;
    while (code.is_word(at)) {
        Declarator one{std::string(code[at].text), {}, {}};
        const std::size_t size = ++at;
        while (code.is(at, "["))
            at = code.after_bracket(at);
        one.size = code.text_of(size, at);
        if (code.is(at, "=")) {
            const std::size_t value = ++at;
            while (at < code.size() && !code.is(at, ",") && !code.is(at, ";"))
                at = change_of_depth(code[at]) > 0 ? code.after_bracket(at) : at + 1;
            one.initialiser = code.text_of(value, at);
        }
        all.push_back(std::move(one));
        if (!code.is(at, ","))
            break;
        ++at;
    }
    return all;
}

// Reads "location = 2" in the brackets from `at` on.
int location_in(const GlobalCode& code, std::size_t at, std::size_t end) {
    for (; at + 2 < end; ++at)
        if (code.is(at, "location") && code.is(at + 1, "="))
            return parse_integer(code[at + 2].text).value_or(-1);
    return -1;
}

std::optional<InterfaceStatement> read_statement(const GlobalCode& code, std::size_t at,
                                                 std::size_t end) {
    InterfaceStatement statement;
    statement.begin = code.begin_of(at);
    statement.end = code.end_of(end - 1);
    bool is_interface = false;
    for (; at < end; ++at) {
        if (code.is(at, "layout") && code.is(at + 1, "(")) {
            const std::size_t after = code.after_bracket(at + 1);
            statement.location = location_in(code, at + 2, after);
            at = after - 1;
            continue;
        }
        if (std::ranges::find(qualifiers, code[at].text) == qualifiers.end())
            break;
        const bool is_input = code.is(at, "in") || code.is(at, "varying");
        is_interface = is_interface || is_input || code.is(at, "uniform") || code.is(at, "out");
        if (is_input || code.is(at, "out"))
            statement.kind = is_input ? Kind::input : Kind::output;
        statement.is_flat = statement.is_flat || code.is(at, "flat");
    }
    if (!is_interface || !code.is_word(at))
        return std::nullopt;
    statement.type = code[at].text;
    statement.type_begin = code.begin_of(at);
    statement.is_block = code.is(at + 1, "{");
    std::size_t name = at + 1;
    while (code.is(name, "["))
        name = code.after_bracket(name);
    if (!statement.is_block)
        statement.declarators = declarators_in(code, name);
    return statement;
}
}  // namespace

std::vector<InterfaceStatement> find_interface_statements(std::string_view text) {
    const GlobalCode code(text);
    std::vector<InterfaceStatement> found;
    for (std::size_t at = 0; at < code.size();) {
        const std::size_t end = code.after_statement(at);
        if (auto statement = read_statement(code, at, end))
            found.push_back(std::move(*statement));
        at = end;
    }
    return found;
}

namespace {
void add_names(const GlobalCode& code, std::size_t at, std::size_t end,
               std::vector<std::string>& names) {
    while (at < end && (code.is(at, "layout") ||
                        std::ranges::find(qualifiers, code[at].text) != qualifiers.end()))
        at = code.is(at, "layout") && code.is(at + 1, "(") ? code.after_bracket(at + 1) : at + 1;
    if (code.is(at, "struct") && code.is_word(at + 1)) {
        names.emplace_back(code[at + 1].text);
        at = code.is(at + 2, "{") ? code.after_bracket(at + 2) : at + 2;
    } else if (code.is_word(at)) {
        ++at;  // the type
        while (code.is(at, "["))
            at = code.after_bracket(at);
    }
    if (at >= end)
        return;
    if (code.is_word(at) && code.is(at + 1, "("))
        names.emplace_back(code[at].text);
    else
        for (const Declarator& one : declarators_in(code, at))
            names.push_back(one.name);
}
}  // namespace

std::vector<std::string> global_names(std::string_view text) {
    std::vector<std::string> names;
    const Tokens tokens = scan(text);
    for (const Directive& directive : find_directives(text, tokens))
        if (directive.name == "define" && !directive.arguments.empty())
            names.emplace_back(directive.arguments.front().text);
    const GlobalCode code(text);
    for (std::size_t at = 0; at < code.size();) {
        const std::size_t end = code.after_statement(at);
        add_names(code, at, end, names);
        at = end;
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}
