#include "glsl/es/es_constants.h"

#include "glsl/constants/constants.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

namespace {
using Names = std::set<std::string_view>;

/// The code of a text without comments and directives, statement by statement.
std::vector<std::vector<Token>> statements_of(const Tokens& tokens) {
    std::vector<std::vector<Token>> statements(1);
    for (const Token& token : tokens.all) {
        if (token.kind == Token::Kind::comment || token.in_directive)
            continue;
        statements.back().push_back(token);
        if (token.is(";") || token.is("{") || token.is("}") || token.is(":"))
            statements.emplace_back();
    }
    return statements;
}

bool names_one_of(const std::vector<Token>& tokens, const Names& names) {
    return std::ranges::any_of(tokens,
                               [&](const Token& token) { return names.contains(token.text); });
}

bool has_word(const std::vector<Token>& tokens, std::string_view word) {
    return std::ranges::find(tokens, word, &Token::text) != tokens.end();
}

// The macros and constants that depend on a constant, with itself.
Names dependent_names(const std::string& name, const std::vector<Directive>& directives,
                      const std::vector<std::vector<Token>>& statements) {
    Names names{name};
    for (std::size_t known = 0; known != names.size();) {
        known = names.size();
        for (const Directive& directive : directives)
            if (directive.name == "define" && names_one_of(directive.arguments, names))
                names.insert(directive.arguments.front().text);
        for (const std::vector<Token>& statement : statements)
            if (has_word(statement, "const") && names_one_of(statement, names))
                for (std::size_t i = 1; i < statement.size(); ++i)
                    if (statement[i].is("=") || statement[i].is("["))
                        names.insert(statement[i - 1].text);
    }
    return names;
}

// Before the shader is compiled, or while it is: by #if and as the label of a case.
bool is_evaluated(const std::string& text, const std::string& name) {
    const Tokens tokens = scan(text);
    const std::vector<Directive> directives = find_directives(text, tokens);
    const auto statements = statements_of(tokens);
    const Names names = dependent_names(name, directives, statements);
    return std::ranges::any_of(directives,
                               [&](const Directive& directive) {
                                   return (directive.name == "if" || directive.name == "elif") &&
                                          names_one_of(directive.arguments, names);
                               }) ||
           std::ranges::any_of(statements, [&](const std::vector<Token>& statement) {
               return has_word(statement, "case") && names_one_of(statement, names);
           });
}

// The end of the line of the last directive that must come first.
std::size_t place_of_declarations(const std::string& text) {
    const Tokens tokens = scan(text);
    std::size_t place = 0;
    for (const Directive& directive : find_directives(text, tokens))
        if (directive.name == "version" || directive.name == "extension")
            place = text.find('\n', directive.end);
    return std::min(place, text.size());
}
}  // namespace

bool can_be_specialized(const std::string& text, const std::string& name) {
    const auto constants = find_constants(text);
    const auto written = std::ranges::find(constants, name, &WrittenConstant::name);
    return written != constants.end() && written->number && !is_evaluated(text, name);
}

std::string with_es_constants(const std::string& text, const std::vector<EsConstant>& constants) {
    std::string result;
    std::string declared;
    std::size_t copied = 0;
    std::set<int> ids;
    for (const WrittenConstant& written : find_constants(text)) {
        const auto wanted = std::ranges::find(constants, written.name, &EsConstant::name);
        if (wanted == constants.end() || !written.number)
            continue;
        result.append(text, copied, written.begin - copied);
        result += fmt::format("es_constant_{}", wanted->id);
        copied = written.end;
        if (ids.insert(wanted->id).second)
            declared += fmt::format("layout(constant_id = {0}) const {1} es_constant_{0} = {2}; ",
                                    wanted->id, glsl_name(written.type),
                                    glsl_number(written.type, *written.number));
    }
    if (copied == 0)
        return text;
    result.append(text, copied);
    const std::size_t place = place_of_declarations(result);
    return result.insert(std::min(place + 1, result.size()), declared + "\n");
}
