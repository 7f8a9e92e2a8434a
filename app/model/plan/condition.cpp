#include "model/plan/condition.h"

#include "base/text.h"
#include "model/look/value_text.h"
#include "model/plan/expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

namespace {
struct Operator {
    std::string_view symbol;
    std::string_view text;
    bool is_comparison;
};

// Longer symbols first.
constexpr std::array operators{
    Operator{"==", "is", true},         Operator{"!=", "is not", true},
    Operator{"<=", "is at most", true}, Operator{">=", "is at least", true},
    Operator{"&&", "and", false},       Operator{"||", "or", false},
    Operator{"<", "is below", true},    Operator{">", "is above", true},
    Operator{"!", "not", false},        Operator{"(", "(", false},
    Operator{")", ")", false},          Operator{"-", "-", false}};

struct Token {
    enum class Kind { name, number, label, symbol };

    Kind kind = Kind::symbol;
    std::string text;                      // a label without its quotes
    const Parameter* parameter = nullptr;  // of a name
    const Operator* symbol = nullptr;

    bool is_comparison() const { return symbol && symbol->is_comparison; }
};

bool is_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// The length of the word or number at the start of `text`.
std::size_t word_length(std::string_view text) {
    const bool is_number = std::isdigit(static_cast<unsigned char>(text.front())) || text[0] == '.';
    const auto end = std::ranges::find_if_not(
        text, [is_number](char c) { return is_letter(c) || (is_number && c == '.'); });
    return static_cast<std::size_t>(end - text.begin());
}

class Condition {
public:
    Condition(const Parameter& parameter, const std::vector<Parameter>& parameters)
        : m_scope(parameter.name.substr(0, parameter.name.rfind('/') + 1)) {
        for (const Parameter& other : parameters)
            if (other.name.starts_with(m_scope))
                m_parameters.push_back(&other);
        for (std::string_view rest = trim(parameter.when); !rest.empty() && m_problem.empty();
             rest = trim(rest))
            rest.remove_prefix(add(rest));
        for (std::size_t i = 0; i < m_tokens.size() && m_problem.empty(); ++i)
            if (m_tokens[i].kind == Token::Kind::label)
                m_problem = problem_of_label(i);
    }

    Result<bool> is_true(const Values& values) const {
        if (!m_problem.empty())
            return fail({{}, 0, m_problem});
        std::string expression;
        std::map<std::string, double> numbers;
        for (std::size_t i = 0; i < m_tokens.size(); ++i) {
            const Token& token = m_tokens[i];
            if (token.parameter) {
                const std::string name = token.parameter->name.substr(m_scope.size());
                numbers[name] = value_of(*token.parameter, values).number();
                expression += '$' + name;
            } else if (token.kind == Token::Kind::label) {
                expression += fmt::format("{}", item_of(i)->value);
            } else {
                expression += token.text;
            }
            expression += ' ';
        }
        const auto value = evaluate(expression, numbers);
        if (!value)
            return fail(value.error());
        return *value != 0.0;
    }

    std::string text() const {
        std::string text;
        for (std::size_t i = 0; i < m_tokens.size(); ++i) {
            const std::string part = text_of(i);
            const bool is_joined = text.empty() || text.ends_with('(') || text.ends_with('-') ||
                                   part == ")" || part.empty();
            text += (is_joined ? "" : " ") + part;
        }
        return text;
    }

private:
    // Adds the token at the start of `rest`, and returns its length.
    std::size_t add(std::string_view rest) {
        if (rest.front() == '"')
            return add_label(rest);
        if (is_letter(rest.front()) || rest.front() == '.')
            return add_word(rest.substr(0, word_length(rest)));
        for (const Operator& symbol : operators)
            if (rest.starts_with(symbol.symbol)) {
                m_tokens.push_back({Token::Kind::symbol, std::string(symbol.symbol), {}, &symbol});
                return symbol.symbol.size();
            }
        m_problem = fmt::format("unexpected '{}'", rest.front());
        return rest.size();
    }

    std::size_t add_label(std::string_view rest) {
        std::string label;
        for (std::size_t i = 1; i < rest.size(); ++i) {
            if (rest[i] == '"') {
                m_tokens.push_back({Token::Kind::label, label});
                return i + 1;
            }
            const bool is_escape = rest[i] == '\\' && i + 1 < rest.size();
            label += is_escape ? rest[++i] : rest[i];
        }
        m_problem = "a label has no closing '\"'";
        return rest.size();
    }

    std::size_t add_word(std::string_view word) {
        if (parse_number(word))
            m_tokens.push_back({Token::Kind::number, std::string(word)});
        else
            add_name(std::string(word));
        return word.size();
    }

    void add_name(const std::string& name) {
        const auto found = std::ranges::find(m_parameters, m_scope + name, &Parameter::name);
        if (found == m_parameters.end()) {
            m_problem = fmt::format("no parameter '{}'{}", name, did_you_mean(name, names()));
        } else if ((*found)->type.size() != 1 || !(*found)->initial.path.empty() ||
                   (*found)->control == Control::image) {
            m_problem = fmt::format("'{}' is not a single number", name);
        } else {
            m_tokens.push_back({Token::Kind::name, name, *found});
        }
    }

    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const Parameter* parameter : m_parameters)
            names.push_back(parameter->name.substr(m_scope.size()));
        return names;
    }

    // The parameter that token `i`, a label or a number, is compared with. nullptr without one.
    const Parameter* compared_with(std::size_t i) const {
        if (i >= 2 && m_tokens[i - 1].is_comparison() && m_tokens[i - 2].parameter)
            return m_tokens[i - 2].parameter;
        if (i + 2 < m_tokens.size() && m_tokens[i + 1].is_comparison())
            return m_tokens[i + 2].parameter;
        return nullptr;
    }

    // The item with the label of token `i`. nullptr without one.
    const Item* item_of(std::size_t i) const {
        const Parameter* const list = compared_with(i);
        if (!list)
            return nullptr;
        const auto found = std::ranges::find(list->items, m_tokens[i].text, &Item::label);
        return found == list->items.end() ? nullptr : &*found;
    }

    std::string problem_of_label(std::size_t i) const {
        const std::string& label = m_tokens[i].text;
        const Parameter* const list = compared_with(i);
        if (!list)
            return fmt::format("\"{}\" is not compared with a parameter", label);
        if (item_of(i))
            return {};
        std::vector<std::string> labels;
        for (const Item& item : list->items)
            labels.push_back(item.label);
        return fmt::format("'{}' has no item \"{}\"{}", list->name.substr(m_scope.size()), label,
                           did_you_mean(label, labels));
    }

    bool is_compared(std::size_t i) const {
        return (i + 1 < m_tokens.size() && m_tokens[i + 1].is_comparison()) ||
               (i > 0 && m_tokens[i - 1].is_comparison());
    }

    bool is_negated_name(std::size_t i) const {
        return i < m_tokens.size() && m_tokens[i].text == "!" && i + 1 < m_tokens.size() &&
               m_tokens[i + 1].parameter && !is_compared(i + 1);
    }

    std::string text_of(std::size_t i) const {
        const Token& token = m_tokens[i];
        if (token.parameter && is_compared(i))
            return token.parameter->label;
        if (token.parameter)
            return text_of_truth(*token.parameter, i > 0 && is_negated_name(i - 1));
        if (const Parameter* const parameter = compared_with(i);
            parameter && token.kind == Token::Kind::number)
            return value_text(*parameter, Value(parse_number(token.text).value_or(0.0)));
        if (token.kind != Token::Kind::symbol)
            return token.text;
        return is_negated_name(i) ? std::string() : std::string(token.symbol->text);
    }

    static std::string text_of_truth(const Parameter& parameter, bool is_negated) {
        if (parameter.type.scalar == Scalar::boolean)
            return fmt::format("{} is {}", parameter.label, is_negated ? "off" : "on");
        return fmt::format("{} is {}0", parameter.label, is_negated ? "" : "not ");
    }

    std::string m_scope;  // the part of a stack: "crt/"
    std::vector<const Parameter*> m_parameters;
    std::vector<Token> m_tokens;
    std::string m_problem;
};
}  // namespace

Diagnostics check_conditions(const std::vector<Parameter>& parameters) {
    Diagnostics problems;
    for (const Parameter& parameter : parameters) {
        if (parameter.when.empty())
            continue;
        const auto valid = Condition(parameter, parameters).is_true({});
        if (!valid)
            problems.push_back(
                {parameter.declared.file, parameter.declared.line,
                 fmt::format("@when of '{}': {}", parameter.name, valid.error()[0].message)});
    }
    return problems;
}

bool is_condition_true(const Parameter& parameter, const std::vector<Parameter>& parameters,
                       const Values& values) {
    return parameter.when.empty() ||
           Condition(parameter, parameters).is_true(values).value_or(true);
}

std::string condition_text(const Parameter& parameter, const std::vector<Parameter>& parameters) {
    return Condition(parameter, parameters).text();
}
