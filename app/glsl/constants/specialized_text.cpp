#include "glsl/constants/specialized_text.h"

#include "glsl/constants/constants.h"
#include "glsl/text/tokens.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace {
std::string written_value(const SpecializedUniform& uniform) {
    NumberType component = uniform.type;
    component.rows = component.columns = 1;
    std::string components;
    for (const double number : uniform.value.numbers)
        components += (components.empty() ? "" : ", ") + glsl_number(component, number);
    const bool is_one = uniform.value.numbers.size() == 1;
    return is_one ? components : glsl_name(uniform.type) + "(" + components + ")";
}

bool can_be_written(const SpecializedUniform& uniform) {
    return static_cast<int>(uniform.value.numbers.size()) == uniform.type.size() &&
           std::ranges::all_of(uniform.value.numbers, [](double number) {
               return std::isfinite(static_cast<float>(number));
           });
}

/// A statement `uniform TYPE NAME;` or `uniform TYPE NAME = ...;`
struct Statement {
    std::string name;
    std::size_t begin = 0;  // of `uniform`: offsets into the text
    std::size_t behind_name = 0;
    std::size_t end = 0;  // of the ';'
};

class StatementReader {
public:
    explicit StatementReader(std::string_view text) : m_text(text) {
        for (const Token& token : scan(text).all)
            if (token.kind != Token::Kind::comment && !token.in_directive)
                m_tokens.push_back(token);
    }

    /// The statement that starts at the token; nullopt for other forms.
    std::optional<Statement> read(std::size_t at, const std::string& type) const {
        const bool has_layout = at > 0 && m_tokens[at - 1].is(")");
        if (!m_tokens[at].is("uniform") || has_layout)
            return std::nullopt;
        Statement statement{{}, begin_of(at), 0, 0};
        ++at;
        if (is(at, "highp") || is(at, "mediump") || is(at, "lowp"))
            ++at;
        if (!is(at, type) || at + 2 >= m_tokens.size())
            return std::nullopt;
        statement.name = m_tokens[at + 1].text;
        statement.behind_name = begin_of(at + 1) + statement.name.size();
        const auto end = end_of_initialiser(at + 2);
        if (!end)
            return std::nullopt;
        statement.end = begin_of(*end);
        return statement;
    }

    std::size_t size() const { return m_tokens.size(); }
    /// If "block.member" starts there: its name and the index of its last token.
    std::optional<std::size_t> member_at(std::size_t at, std::string& name) const {
        const bool is_word = m_tokens[at].kind == Token::Kind::word && is(at + 1, ".");
        if (!is_word || at + 2 >= m_tokens.size() || (at > 0 && is(at - 1, ".")))
            return std::nullopt;
        name = std::string(m_tokens[at].text) + "." + std::string(m_tokens[at + 2].text);
        return at + 2;
    }
    std::size_t begin_of(std::size_t at) const {
        return static_cast<std::size_t>(m_tokens[at].text.data() - m_text.data());
    }
    std::size_t end_of(std::size_t at) const { return begin_of(at) + m_tokens[at].text.size(); }

    /// The name of a uniform declared there, if it has a known form; otherwise "".
    std::string name_at(std::size_t at) const {
        if (!is(at, "uniform"))
            return {};
        const bool has_precision =
            is(at + 1, "highp") || is(at + 1, "mediump") || is(at + 1, "lowp");
        const std::size_t index = at + (has_precision ? 3 : 2);
        return index < m_tokens.size() ? std::string(m_tokens[index].text) : std::string();
    }

private:
    bool is(std::size_t at, std::string_view word) const {
        return at < m_tokens.size() && m_tokens[at].is(word);
    }

    // The index of the ';' if a single name is declared.
    std::optional<std::size_t> end_of_initialiser(std::size_t at) const {
        if (!is(at, "=") && !is(at, ";"))
            return std::nullopt;
        for (int depth = 0; at < m_tokens.size(); ++at) {
            if (is(at, "(") || is(at, "[") || is(at, "{"))
                ++depth;
            else if (is(at, ")") || is(at, "]") || is(at, "}"))
                --depth;
            else if (depth == 0 && is(at, ","))
                return std::nullopt;
            else if (depth == 0 && is(at, ";"))
                return at;
        }
        return std::nullopt;
    }

    std::string_view m_text;
    std::vector<Token> m_tokens;
};

/// Copies a text with replacements.
class Copy {
public:
    explicit Copy(const std::string& text) : m_text(text) {}

    void up_to(std::size_t end) {
        m_copy.append(m_text, m_copied, end - m_copied);
        m_copied = end;
    }
    void without(std::size_t end) { m_copied = end; }
    void add(const std::string& text) { m_copy += text; }
    std::string rest() && { return std::move(m_copy.append(m_text, m_copied)); }

private:
    const std::string& m_text;
    std::string m_copy;
    std::size_t m_copied = 0;
};

void specialize(const Statement& statement, const SpecializedUniform& uniform,
                const std::string& text, Copy& copy) {
    const auto at = [&](std::size_t index) {
        return text.begin() + static_cast<std::ptrdiff_t>(index);
    };
    copy.up_to(statement.begin);
    copy.without(statement.begin + std::string_view("uniform").size());
    copy.up_to(statement.behind_name);
    copy.add(" = " + written_value(uniform));
    const auto lines = std::count(at(statement.behind_name), at(statement.end), '\n');
    copy.add(std::string(static_cast<std::size_t>(lines), '\n'));
    copy.without(statement.end);
}
}  // namespace

std::string specialized_text(const std::string& text,
                             const std::map<std::string, SpecializedUniform>& uniforms) {
    const StatementReader reader(text);
    const auto find = [&](const std::string& name) -> const SpecializedUniform* {
        const auto found = uniforms.find(name);
        return found != uniforms.end() && can_be_written(found->second) ? &found->second : nullptr;
    };
    Copy copy(text);
    for (std::size_t at = 0; at < reader.size(); ++at) {
        std::string member;
        const auto last = reader.member_at(at, member);
        if (const SpecializedUniform* uniform = last ? find(member) : nullptr) {
            copy.up_to(reader.begin_of(at));
            copy.add(written_value(*uniform));
            copy.without(reader.end_of(*last));
            at = *last;
        } else if (const SpecializedUniform* declared = find(reader.name_at(at))) {
            if (const auto statement = reader.read(at, glsl_name(declared->type)))
                specialize(*statement, *declared, text, copy);
        }
    }
    return std::move(copy).rest();
}
