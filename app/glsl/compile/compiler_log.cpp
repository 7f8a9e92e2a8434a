#include "glsl/compile/compiler_log.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace {
using Spelling = std::pair<std::string_view, std::string_view>;

// Token names of glslang's grammar and their spelling in source code.
constexpr std::array spellings{
    Spelling{"LEFT_PAREN", "'('"},
    Spelling{"RIGHT_PAREN", "')'"},
    Spelling{"LEFT_BRACKET", "'['"},
    Spelling{"RIGHT_BRACKET", "']'"},
    Spelling{"LEFT_BRACE", "'{'"},
    Spelling{"RIGHT_BRACE", "'}'"},
    Spelling{"SEMICOLON", "';'"},
    Spelling{"COMMA", "','"},
    Spelling{"COLON", "':'"},
    Spelling{"DOT", "'.'"},
    Spelling{"EQUAL", "'='"},
    Spelling{"PLUS", "'+'"},
    Spelling{"DASH", "'-'"},
    Spelling{"STAR", "'*'"},
    Spelling{"SLASH", "'/'"},
    Spelling{"PERCENT", "'%'"},
    Spelling{"LEFT_ANGLE", "'<'"},
    Spelling{"RIGHT_ANGLE", "'>'"},
    Spelling{"BANG", "'!'"},
    Spelling{"TILDE", "'~'"},
    Spelling{"QUESTION", "'?'"},
    Spelling{"AMPERSAND", "'&'"},
    Spelling{"VERTICAL_BAR", "'|'"},
    Spelling{"CARET", "'^'"},
    Spelling{"INC_OP", "'++'"},
    Spelling{"DEC_OP", "'--'"},
    Spelling{"EQ_OP", "'=='"},
    Spelling{"NE_OP", "'!='"},
    Spelling{"LE_OP", "'<='"},
    Spelling{"GE_OP", "'>='"},
    Spelling{"AND_OP", "'&&'"},
    Spelling{"OR_OP", "'||'"},
    Spelling{"XOR_OP", "'^^'"},
    Spelling{"ADD_ASSIGN", "'+='"},
    Spelling{"SUB_ASSIGN", "'-='"},
    Spelling{"MUL_ASSIGN", "'*='"},
    Spelling{"DIV_ASSIGN", "'/='"},
    Spelling{"LEFT_OP", "'<<'"},
    Spelling{"RIGHT_OP", "'>>'"},
    Spelling{"IDENTIFIER", "a name"},
    Spelling{"TYPE_NAME", "a type"},
    Spelling{"INTCONSTANT", "a whole number"},
    Spelling{"UINTCONSTANT", "a whole number"},
    Spelling{"FLOATCONSTANT", "a number"},
    Spelling{"BOOLCONSTANT", "true or false"},
};

bool is_shouted(std::string_view word) {
    return word.size() > 1 && std::ranges::all_of(word, [](char c) {
               return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
           });
}

std::string spelled(std::string_view word) {
    const auto found = std::ranges::find(spellings, word, &Spelling::first);
    if (found != spellings.end())
        return std::string(found->second);
    return is_shouted(word) ? '\'' + to_lower(word) + '\'' : std::string(word);
}

// Replaces token names: "syntax error, unexpected RIGHT_BRACE, expecting COMMA or SEMICOLON".
std::string with_signs_spelled(std::string_view message) {
    std::string text;
    for (std::string_view word : split(message, ' ')) {
        const bool has_comma = word.ends_with(',');
        if (has_comma)
            word.remove_suffix(1);
        text += (text.empty() ? "" : " ") + spelled(word) + (has_comma ? "," : "");
    }
    return text;
}

std::string with_single_blanks(std::string_view message) {
    std::string text;
    for (const char c : message)
        if (c != ' ' || !text.ends_with(' '))
            text += c;
    return text;
}

// Without glslang's list of extensions that support strings.
constexpr std::string_view no_quotes = "GLSL has no strings";

// Removes decoration: "'' :  syntax error", "'foo' : undeclared identifier ".
std::string cleaned(std::string_view message) {
    message = trim(message);
    if (message.starts_with("'' :"))
        message = trim(message.substr(4));
    if (message.starts_with("memory exhausted"))
        return "the code is nested too deeply for the compiler";
    if (message.starts_with("'string literal'"))
        return std::string(no_quotes);
    if (message.starts_with("syntax error"))
        return with_signs_spelled(message);
    return with_single_blanks(message);
}

// glslang stops after the statement with the first error. Further errors on its line follow from
// that error: an undeclared name is treated as a float, for example.
bool follows_from(const CompilerMessage& message, const CompilerMessage& before) {
    return !message.is_warning && !before.is_warning && message.line > 0 &&
           message.line == before.line;
}

// Whether the next error on the same line says more.
bool is_vague(const CompilerMessage& message) {
    return message.text.starts_with("'scalar swizzle' : not supported") ||
           message.text.starts_with("'constructor' : can't convert");
}

bool is_noise(std::string_view message) {
    return message.find("compilation terminated") != std::string_view::npos ||
           message.find("No code generated") != std::string_view::npos;
}

// Parses "0:12: text": index of the text, line, message.
CompilerMessage located(std::string_view rest) {
    CompilerMessage message;
    const std::size_t first = rest.find(':');
    const std::size_t second = first == std::string_view::npos ? first : rest.find(':', first + 1);
    if (second != std::string_view::npos) {
        const auto line = parse_integer(rest.substr(first + 1, second - first - 1));
        if (line && parse_integer(rest.substr(0, first))) {
            message.line = *line;
            rest = rest.substr(second + 1);
        }
    }
    constexpr std::string_view linking = "Linking ";
    if (message.line == 0 && rest.starts_with(linking)) {
        message.is_about_vertex_stage = rest.starts_with("Linking vertex stage");
        const std::size_t colon = rest.find(": ");
        rest = colon == std::string_view::npos ? rest : rest.substr(colon + 2);
    }
    message.text = cleaned(rest);
    if (message.text.starts_with("Missing entry point"))
        message.text = "the shader has no main()";
    return message;
}

// A broken text can cause a message per word. The last message of a kind reports the limit.
void add_message(std::vector<CompilerMessage>& messages, CompilerMessage message) {
    constexpr std::ptrdiff_t maximum = 256;
    const auto count =
        std::ranges::count(messages, message.is_warning, &CompilerMessage::is_warning);
    if (count == maximum)
        message.text =
            message.is_warning
                ? fmt::format("more than {0} warnings; only the first {0} are listed", maximum)
                : fmt::format("more than {0} errors; only the first {0} are listed", maximum);
    if (count <= maximum)
        messages.push_back(std::move(message));
}

// Adds a line after a link message, with mangled function names: "f(f1; calling g(f1;".
void add_detail(CompilerMessage& message, std::string_view detail) {
    std::string plain;
    for (const std::string_view word : split(trim(detail), ' ')) {
        const std::size_t bracket = word.find('(');
        const bool is_function = bracket != std::string_view::npos && word.ends_with(';');
        if (is_function && message.subject.empty())
            message.subject = word.substr(0, bracket);
        plain += plain.empty() ? "" : " ";
        plain += is_function ? std::string(word.substr(0, bracket)) + "()" : std::string(word);
    }
    message.text += (message.text.ends_with(':') ? " " : ", ") + plain;
}
}  // namespace

std::vector<CompilerMessage> parse_compiler_log(std::string_view log) {
    std::vector<CompilerMessage> messages;
    for (const std::string_view line : split_lines(log)) {
        constexpr std::string_view error = "ERROR: ";
        constexpr std::string_view warning = "WARNING: ";
        if (trim(line).empty() || is_noise(line))
            continue;
        const bool is_warning = line.starts_with(warning);
        if (line.starts_with(error) || is_warning) {
            CompilerMessage message =
                located(line.substr(is_warning ? warning.size() : error.size()));
            message.is_warning = is_warning;
            if (messages.empty() || !follows_from(message, messages.back()))
                add_message(messages, std::move(message));
            else if (is_vague(messages.back()))
                messages.back() = std::move(message);
        } else if (!messages.empty() && messages.back().text != no_quotes) {
            add_detail(messages.back(), line);
        }
    }
    return messages;
}
