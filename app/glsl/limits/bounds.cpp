#include "glsl/limits/bounds.h"

#include "glsl/limits/macro_weights.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace {
// glslang 12 overflows a stack of 8 MiB at about 30000 operators in a row.
constexpr double max_in_statement = 16'384;
constexpr double max_in_text = 1'000'000;
constexpr int max_nested = 256;
constexpr int max_structs = 1000;

std::optional<LimitViolation> find_deep_nesting(std::span<const Token> tokens) {
    int depth = 0;
    for (const Token& token : tokens) {
        if (token.starts_directive)
            depth = 0;
        if (token.is("(") || token.is("[") || token.is("{"))
            ++depth;
        else if (token.is(")") || token.is("]") || token.is("}"))
            depth = std::max(depth - 1, 0);
        if (depth > max_nested)
            return LimitViolation{
                token.line,
                fmt::format("brackets are nested deeper than the limit of {} levels", max_nested)};
    }
    return std::nullopt;
}

// Whether a '(' opens the comma-separated arguments of a call or constructor.
bool opens_list(std::span<const Token> code, std::size_t at) {
    constexpr std::array<std::string_view, 5> statements{"if", "for", "while", "switch", "return"};
    if (at == 0 || !code[at].is("("))
        return false;
    const Token& before = code[at - 1];
    return before.is("]") || (before.kind == Token::Kind::word &&
                              std::ranges::find(statements, before.text) == statements.end());
}

// The tokens of a macro use: its name and the brackets that follow.
std::span<const Token> macro_use(std::span<const Token> code) {
    std::size_t end = 1;
    int depth = 0;
    while (end < code.size() && (depth > 0 || code[end].is("("))) {
        depth += code[end].is("(") ? 1 : code[end].is(")") ? -1 : 0;
        ++end;
        if (depth == 0)
            break;
    }
    return code.first(end);
}

// The number of tokens, where an argument list counts as its longest item. The items of a list are
// siblings in a compiler's tree, so they do not nest. Macros must be balanced.
double without_lists(std::span<const Token> code, MacroWeights& weights) {
    struct Level {
        bool is_list = false;
        double item = 0.0;
        double longest = 0.0;
    };
    std::vector<Level> levels(1);
    for (std::size_t i = 0; i < code.size(); ++i) {
        Level& level = levels.back();
        const auto part =
            weights.is_macro(code[i]) ? macro_use(code.subspan(i)) : code.subspan(i, 1);
        level.item += weights.weight_of(part);
        level.longest = std::max(level.longest, level.item);
        i += part.size() - 1;
        if (part.size() > 1)
            continue;
        if (code[i].is("(")) {
            levels.push_back({.is_list = opens_list(code, i)});
        } else if (code[i].is(",") && level.is_list) {
            level.item = 0.0;
        } else if (code[i].is(")") && levels.size() > 1) {
            const double inside = level.longest;
            levels.pop_back();
            levels.back().item += inside;
        }
    }
    double sum = 0.0;
    for (const Level& level : levels)
        sum += std::max(level.longest, level.item);
    return sum;
}

class Measure {
public:
    explicit Measure(const std::vector<Directive>& directives) : m_weights(directives) {}

    std::optional<LimitViolation> add(std::span<const Token> statement) {
        if (statement.empty())
            return std::nullopt;
        const double weight = m_weights.weight_of(statement);
        m_total += weight;
        const int line = statement.front().line;
        if (weight > max_in_statement &&
            (!m_weights.are_balanced() || without_lists(statement, m_weights) > max_in_statement))
            return LimitViolation{
                line, fmt::format("this statement has more tokens than the limit of {}, "
                                  "counted with macros expanded",
                                  max_in_statement)};
        if (m_total > max_in_text)
            return LimitViolation{line,
                                  fmt::format("the shader has more tokens than the limit of {}, "
                                              "counted with macros expanded",
                                              max_in_text)};
        return std::nullopt;
    }

private:
    MacroWeights m_weights;
    double m_total = 0.0;
};

// Statements end at ; { } outside round brackets; a macro's argument may contain these.
std::optional<LimitViolation> find_long_statement(std::span<const Token> code, Measure& measure) {
    std::size_t begin = 0;
    int depth = 0;
    int structs = 0;
    for (std::size_t i = 0; i < code.size(); ++i) {
        if (code[i].is("struct") && ++structs > max_structs)
            return LimitViolation{
                code[i].line,
                fmt::format("the shader has more structs than the limit of {}", max_structs)};
        depth = std::max(depth + (code[i].is("(") ? 1 : code[i].is(")") ? -1 : 0), 0);
        const bool ends = depth == 0 && (code[i].is(";") || code[i].is("{") || code[i].is("}"));
        if (!ends && i + 1 < code.size())
            continue;
        if (auto problem = measure.add(code.subspan(begin, i + 1 - begin)))
            return problem;
        begin = i + 1;
    }
    return std::nullopt;
}
}  // namespace

std::optional<LimitViolation> find_limit_violation(std::string_view text) {
    const Tokens tokens = scan(text);
    std::vector<Token> code;
    std::vector<Token> lines;
    for (const Token& token : tokens.all)
        if (token.kind != Token::Kind::comment)
            (token.in_directive ? lines : code).push_back(token);
    for (const auto& part : {code, lines})
        if (auto problem = find_deep_nesting(part))
            return problem;

    const std::vector<Directive> directives = find_directives(text, tokens);
    Measure measure(directives);
    for (const Directive& directive : directives)
        if (directive.name == "if" || directive.name == "elif")
            if (auto problem = measure.add(directive.arguments))
                return problem;
    return find_long_statement(code, measure);
}
