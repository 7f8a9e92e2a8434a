#include "formats/effect/effect_text.h"

#include "glsl/compile/built_in_names.h"
#include "glsl/text/interface_statements.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
using Kind = InterfaceStatement::Kind;

/// A part of a text to replace.
struct TextEdit {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string text;
};

std::string line_ends(std::string_view text) {
    return std::string(static_cast<std::size_t>(std::ranges::count(text, '\n')), '\n');
}

// The statement stays readable.
std::string as_comment(std::string_view statement) {
    return statement.find("*/") == statement.npos ? fmt::format("/* {} */", statement)
                                                  : line_ends(statement);
}

std::string zero_of(const InterfaceStatement& statement) {
    return statement.type.find("sampler") == std::string::npos ? statement.type + "(0)" : "";
}

std::string edited(std::string_view text, const std::vector<TextEdit>& edits) {
    std::string result;
    std::size_t done = 0;
    for (const TextEdit& edit : edits) {
        result += text.substr(done, edit.begin - done);
        result += edit.text;
        done = edit.end;
    }
    result += text.substr(done);
    return result;
}

// Whether a word can name components of a vector, such as "xy" or "r".
bool is_swizzle(std::string_view word) {
    const auto has_only = [&](std::string_view letters) {
        return word.find_first_not_of(letters) == word.npos;
    };
    return word.size() <= 4 && (has_only("xyzw") || has_only("rgba") || has_only("stpq"));
}

/// Follows the tokens of a text, to tell members from variables.
class Members {
public:
    void pass(const Token& token) {
        m_is_after_dot = token.is(".");
        if (token.is("struct"))
            m_is_struct = true;
        if (m_is_struct && token.is("{"))
            ++m_depth;
        if (m_is_struct && token.is("}") && --m_depth <= 0) {
            m_is_struct = false;
            m_depth = 0;
        }
    }
    /// Whether the next word is a component of a vector, or a member with the name of one.
    bool is_next(std::string_view word) const {
        return (m_is_after_dot || m_depth > 0) && is_swizzle(word);
    }

private:
    bool m_is_after_dot = false;
    bool m_is_struct = false;
    int m_depth = 0;
};

// The edits that rename words in code and directives; comments and components of vectors stay.
std::vector<TextEdit> word_edits(std::string_view text, const WordChanges& words) {
    std::vector<TextEdit> edits;
    if (words.empty())
        return edits;
    Members members;
    for (const Token& token : scan(text).all) {
        if (token.kind == Token::Kind::comment)
            continue;
        const bool is_member = members.is_next(token.text);
        members.pass(token);
        const auto change = words.find(token.text);
        if (token.kind != Token::Kind::word || is_member || change == words.end())
            continue;
        const auto begin = static_cast<std::size_t>(token.text.data() - text.data());
        edits.push_back({begin, begin + token.text.size(), change->second});
    }
    return edits;
}

std::string renamed(std::string_view text, const WordChanges& words) {
    return edited(text, word_edits(text, words));
}

// A value of the rules is not renamed.
std::string variable(const InterfaceStatement& statement, const Declarator& name,
                     const EffectTextRules& rules) {
    if (const auto constant = rules.constants.find(name.name); constant != rules.constants.end())
        return fmt::format("const {} {} = {};", constant->second.type,
                           renamed(name.name, rules.words), constant->second.value);
    const auto value = rules.values.find(name.name);
    if (value != rules.values.end() && value->second.empty())
        return renamed(statement.type + " " + name.name + name.size, rules.words) + ";";
    std::string initial =
        value != rules.values.end()
            ? fmt::format("{}({})", renamed(statement.type, rules.words), value->second)
            : renamed(name.initialiser, rules.words);
    if (initial.empty() && name.size.empty())
        initial = renamed(zero_of(statement), rules.words);
    return fmt::format("{}{}{};",
                       renamed(statement.type + " " + name.name + name.size, rules.words),
                       initial.empty() ? "" : " = ", initial);
}

std::string changed_uniform(const InterfaceStatement& statement, std::string_view text,
                            const EffectTextRules& rules) {
    const auto is_declared = [&](const Declarator& name) {
        return rules.declared.contains(name.name);
    };
    if (!statement.declarators.empty() && std::ranges::all_of(statement.declarators, is_declared))
        return as_comment(text);
    std::string changed;
    for (const Declarator& name : statement.declarators)
        if (!is_declared(name))
            changed += (changed.empty() ? "" : " ") + variable(statement, name, rules);
    return changed + line_ends(text);
}

std::string changed_statement(const InterfaceStatement& statement, std::string_view text,
                              const EffectTextRules& rules) {
    if (statement.is_block)
        return renamed(text, rules.words);
    if (statement.kind == Kind::uniform)
        return changed_uniform(statement, text, rules);
    const std::string& qualifiers = statement.kind == Kind::input ? rules.input : rules.output;
    const std::string rest =
        renamed(text.substr(statement.type_begin - statement.begin), rules.words);
    return qualifiers.empty() ? rest : fmt::format("{} {}", qualifiers, rest);
}

// Directives that another program does not accept inside its files.
bool is_removed(const Directive& directive) {
    return directive.name == "version" || directive.name == "extension" ||
           directive.name == "line" ||
           (directive.name == "pragma" && !directive.arguments.empty() &&
            directive.arguments.front().is("once"));
}

std::vector<TextEdit> edits_of(std::string_view text, const EffectTextRules& rules) {
    std::vector<TextEdit> edits;
    const Tokens tokens = scan(text);
    for (const Directive& directive : find_directives(text, tokens))
        if (is_removed(directive))
            edits.push_back({directive.begin, directive.end, {}});
    for (const InterfaceStatement& statement : find_interface_statements(text)) {
        const std::string_view part = text.substr(statement.begin, statement.end - statement.begin);
        edits.push_back(
            {statement.begin, statement.end, changed_statement(statement, part, rules)});
    }
    const std::vector<TextEdit> whole = edits;
    for (TextEdit& word : word_edits(text, rules.words))
        if (std::ranges::none_of(whole, [&](const TextEdit& edit) {
                return word.begin >= edit.begin && word.begin < edit.end;
            }))
            edits.push_back(std::move(word));
    std::ranges::sort(edits, {}, &TextEdit::begin);
    return edits;
}
}  // namespace

std::string effect_text(std::string_view text, const EffectTextRules& rules) {
    return edited(text, edits_of(text, rules));
}

std::string renamed_word(const WordChanges& words, const std::string& word) {
    const auto change = words.find(word);
    return change == words.end() ? word : change->second;
}

WordChanges renamed_built_ins(std::string_view text) {
    const std::vector<std::string>& functions =
        find_built_in_names({.version = 450, .is_vulkan = true}).functions;
    const std::vector<std::string> names = global_names(text);
    WordChanges words;
    for (const std::string& name : names) {
        if (std::ranges::find(functions, name) == functions.end() &&
            !name.starts_with("afterglow_"))
            continue;
        std::string other = "own_" + name;
        while (std::ranges::find(names, other) != names.end())
            other.insert(0, "own_");
        words.emplace(name, std::move(other));
    }
    return words;
}

std::vector<std::string> extension_lines(std::string_view text) {
    std::vector<std::string> lines;
    const Tokens tokens = scan(text);
    for (const Directive& directive : find_directives(text, tokens)) {
        if (directive.name != "extension")
            continue;
        std::string line(text.substr(directive.begin, directive.end - directive.begin));
        if (std::ranges::find(lines, line) == lines.end())
            lines.push_back(std::move(line));
    }
    return lines;
}
