#include "glsl/es/es_constants.h"

#include "glsl/constants/constants.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace {
bool names_one_of(const Directive& directive, const std::set<std::string_view>& names) {
    return std::ranges::any_of(directive.arguments,
                               [&](const Token& token) { return names.contains(token.text); });
}

// Also through other macros.
bool is_evaluated(const std::string& text, const std::string& name) {
    const Tokens tokens = scan(text);
    const std::vector<Directive> directives = find_directives(text, tokens);
    std::set<std::string_view> names{name};
    for (std::size_t known = 0; known != names.size();) {
        known = names.size();
        for (const Directive& directive : directives)
            if (directive.name == "define" && names_one_of(directive, names))
                names.insert(directive.arguments.front().text);
    }
    return std::ranges::any_of(directives, [&](const Directive& directive) {
        return (directive.name == "if" || directive.name == "elif") &&
               names_one_of(directive, names);
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
