#include "glsl/compile/plain_messages.h"

#include "base/text.h"
#include "glsl/compile/type_names.h"
#include "glsl/text/field_access.h"
#include "glsl/text/shader_names.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace {
/// A message of glslang: 'subject' : reason.
struct Parts {
    std::string subject;
    std::string reason;
};

std::optional<Parts> parts_of(std::string_view message) {
    const std::size_t end = message.find("' : ");
    if (!message.starts_with('\'') || end == std::string_view::npos)
        return std::nullopt;
    return Parts{std::string(message.substr(1, end - 1)),
                 std::string(trim(message.substr(end + 4)))};
}

// The text between two marks; "" if they are missing.
std::string_view between(std::string_view text, std::string_view before, std::string_view after) {
    const std::size_t begin = text.find(before);
    if (begin == std::string_view::npos)
        return {};
    const std::size_t start = begin + before.size();
    const std::size_t end = text.find(after, start);
    return end == std::string_view::npos ? std::string_view() : text.substr(start, end - start);
}

/// Rewrites the messages about one text.
class Explainer {
public:
    Explainer(const std::string& text, const Dialect& dialect) : m_text(text), m_dialect(dialect) {}

    void explain(CompilerMessage& message) {
        if (message.line < 1)
            return;
        if (m_line != message.line)
            m_names.reset();
        m_line = message.line;
        if (message.text.starts_with("syntax error")) {
            message.text += misspelt_keyword(message.text);
            return;
        }
        if (message.text == "boolean expression expected") {
            message.text = "the condition must be a bool";
            return;
        }
        const auto parts = parts_of(message.text);
        if (!parts)
            return;
        const auto rule = std::ranges::find_if(
            rules, [&parts](const Rule& one) { return parts->reason.starts_with(one.reason); });
        message.text = rule == rules.end() ? fmt::format("'{}': {}", parts->subject, parts->reason)
                                           : (this->*rule->text)(*parts);
    }

private:
    struct Rule {
        std::string_view reason;  // how glslang's reason begins
        std::string (Explainer::*text)(const Parts&);
    };
    static const std::array<Rule, 18> rules;

    const ShaderNames& names() {
        if (!m_names)
            m_names = names_at(m_text, m_line);
        return *m_names;
    }

    const BuiltInNames& built_ins() const { return find_built_in_names(m_dialect); }

    // Suggests nothing for a word of one or two letters, except in another case.
    static std::string suggestion(const std::string& name, std::vector<std::string> candidates) {
        std::erase_if(candidates, [&name](const std::string& other) {
            const bool is_internal = other.starts_with("afterglow_") || other.starts_with("isf_");
            return is_internal || (name.size() < 3 && to_lower(other) != to_lower(name));
        });
        return did_you_mean(name, candidates);
    }

    std::vector<std::string> function_candidates() {
        std::vector<std::string> all;
        for (const FunctionName& function : names().functions)
            all.push_back(function.name);
        for (const StructName& one : names().structs)
            all.push_back(one.name);
        all.insert(all.end(), names().macros.begin(), names().macros.end());
        all.insert(all.end(), built_ins().functions.begin(), built_ins().functions.end());
        all.insert(all.end(), common_glsl_types().begin(), common_glsl_types().end());
        return all;
    }

    std::vector<std::string> candidates() {
        std::vector<std::string> all;
        for (const TypedName& variable : names().variables)
            all.push_back(variable.name);
        const std::vector<std::string> functions = function_candidates();
        all.insert(all.end(), functions.begin(), functions.end());
        all.insert(all.end(), built_ins().variables.begin(), built_ins().variables.end());
        all.insert(all.end(), glsl_keywords().begin(), glsl_keywords().end());
        return all;
    }

    // A word of the line that is a keyword or a type with a mistake.
    std::string misspelt_keyword(std::string_view message) {
        if (message.find("unexpected a name") == std::string_view::npos)
            return {};
        std::vector<std::string> words = common_glsl_types();
        words.insert(words.end(), glsl_keywords().begin(), glsl_keywords().end());
        const std::vector<std::string> known = candidates();
        const Tokens tokens = scan(m_text);
        for (const Token& token : tokens.all) {
            if (token.line != m_line || token.kind != Token::Kind::word || token.in_directive ||
                std::ranges::find(known, token.text) != known.end())
                continue;
            if (const std::string hint = suggestion(std::string(token.text), words); !hint.empty())
                return fmt::format(", at '{}'{}", token.text, hint);
        }
        return {};
    }

    std::string type_name(std::string_view description) {
        std::string name = glsl_type_name(description);
        const std::vector<std::string> fields = described_fields(description);
        for (const StructName& one : names().structs)
            if (!fields.empty() && !one.name.empty() &&
                std::ranges::equal(fields, one.fields, {}, {}, &TypedName::name))
                return one.name + name.substr(name.starts_with("struct") ? 6 : 5);
        return name;
    }

    std::string undeclared(const Parts& parts) {
        return fmt::format("'{}' is undeclared{}", parts.subject,
                           suggestion(parts.subject, candidates()));
    }

    std::string no_field(const Parts& parts) {
        std::string type = type_before_field(m_text, m_line, parts.subject, names());
        const std::string_view variable = between(parts.reason, "'", "'");
        if (const TypedName* known = names().find_variable(variable); type.empty() && known)
            type = known->type;
        const std::string owner = variable.empty() ? type : fmt::format("'{}'", variable);
        std::string text = fmt::format("'{}' is not a field{}{}", parts.subject,
                                       owner.empty() ? "" : " of ", owner);
        const StructName* fields = names().find_struct(type);
        return fields ? text + field_hint(parts.subject, *fields) : text;
    }

    static std::string field_hint(const std::string& name, const StructName& owner) {
        std::vector<std::string> fields;
        for (const TypedName& field : owner.fields)
            fields.push_back(field.name);
        if (std::string hint = suggestion(name, fields); !hint.empty())
            return hint;
        constexpr std::size_t most = 8;
        const bool is_cut = fields.size() > most;
        fields.resize(std::min(fields.size(), most));
        return fields.empty()
                   ? std::string()
                   : fmt::format(" (it has {}{})", fmt::join(fields, ", "), is_cut ? ", …" : "");
    }

    std::string no_overload(const Parts& parts) {
        std::vector<std::string> declared;
        for (const FunctionName& function : names().functions)
            if (function.name == parts.subject)
                declared.push_back(fmt::format("({})", fmt::join(function.parameters, ", ")));
        constexpr std::size_t most = 3;
        const bool is_cut = declared.size() > most;
        declared.resize(std::min(declared.size(), most));
        if (!declared.empty())
            return fmt::format("'{}' does not accept these arguments: it takes {}{}", parts.subject,
                               fmt::join(declared, " or "), is_cut ? " or others" : "");
        const auto& functions = built_ins().functions;
        if (std::ranges::find(functions, parts.subject) != functions.end())
            return fmt::format("'{}' does not accept these arguments", parts.subject);
        return fmt::format("'{}' is not a function{}", parts.subject,
                           suggestion(parts.subject, function_candidates()));
    }

    std::string cannot_convert(const Parts& parts) {
        const std::string sign = parts.subject == "assign" ? "=" : parts.subject;
        const std::string_view from = between(parts.reason, "from '", "' to '");
        const std::string_view to = between(parts.reason, "' to '", "'");
        return fmt::format("'{}': cannot convert {} to {}", sign, type_name(from), type_name(to));
    }

    std::string wrong_operands(const Parts& parts) {
        const std::string_view left = between(parts.reason, "left-hand operand of type '", "'");
        const std::string_view right = between(parts.reason, "right operand of type '", "'");
        return fmt::format("'{}' cannot combine {} and {}", parts.subject, type_name(left),
                           type_name(right));
    }

    std::string wrong_operand(const Parts& parts) {
        const std::string_view only = between(parts.reason, "operand of type ", " (or there");
        return fmt::format("'{}' cannot be applied to {}", parts.subject, type_name(only));
    }

    std::string cannot_assign(const Parts& parts) {
        const std::string_view name = between(parts.reason, "\"", "\"");
        std::string_view why = between(parts.reason, "(can't modify ", ")");
        if (why == "shader input")
            why = "a shader input";
        else if (why == "a const")
            why = "a constant";
        if (why.empty())
            return "'=': the left side must be a variable";
        return name.empty() ? fmt::format("'=': the left side is {}, which cannot be changed", why)
                            : fmt::format("'{}' is {}, which cannot be changed", name, why);
    }

    // What precedes a swizzle: "vec2", or "the vector".
    std::string vector_before(const std::string& components) {
        const std::string type = type_before_field(m_text, m_line, components, names());
        return type.empty() ? "the vector" : type;
    }

    std::string missing_component(const Parts& parts) {
        return fmt::format("'{}' has a component that {} does not have", parts.subject,
                           vector_before(parts.subject));
    }

    std::string unknown_component(const Parts& parts) {
        return fmt::format("'{}' is not a component of {}; components are xyzw, rgba or stpq",
                           parts.subject, vector_before(parts.subject));
    }

    std::string mixed_components(const Parts& parts) {
        return fmt::format("'{}' mixes names of components; use either xyzw, rgba or stpq",
                           parts.subject);
    }

    std::string on_array(const Parts& parts) {
        const std::string name(
            trim(std::string_view(parts.reason).substr(parts.reason.find(':') + 1)));
        return fmt::format("'{}' cannot be read from an array{}", name,
                           suggestion(name, {"length"}));
    }

    std::string too_few_values(const Parts&) { return "the constructor needs more values"; }
    std::string too_many_values(const Parts&) { return "the constructor has too many values"; }
    std::string other_field_count(const Parts&) {
        return "the constructor needs one value for each field of the struct";
    }

    std::string cannot_construct(const Parts& parts) {
        return fmt::format("'{}' cannot be constructed from these values",
                           type_name(parts.subject));
    }

    std::string reserved(const Parts& parts) {
        return fmt::format("'{}' is a reserved word; choose another name", parts.subject);
    }

    std::string declared_twice(const Parts& parts) {
        return fmt::format("'{}' is declared twice", parts.subject);
    }

    std::string not_a_function(const Parts& parts) {
        return fmt::format("'{}' is a variable, not a function", parts.subject);
    }

    const std::string& m_text;
    Dialect m_dialect;
    int m_line = 0;
    std::optional<ShaderNames> m_names;  // of that line
};

const std::array<Explainer::Rule, 18> Explainer::rules{{
    {"undeclared identifier", &Explainer::undeclared},
    {"no such field in structure", &Explainer::no_field},
    {"no matching overloaded function found", &Explainer::no_overload},
    {"cannot convert from '", &Explainer::cannot_convert},
    {"wrong operand types", &Explainer::wrong_operands},
    {"wrong operand type", &Explainer::wrong_operand},
    {"l-value required", &Explainer::cannot_assign},
    {"vector swizzle selection out of range", &Explainer::missing_component},
    {"unknown swizzle selection", &Explainer::unknown_component},
    {"vector swizzle selectors not from the same set", &Explainer::mixed_components},
    {"cannot apply to an array", &Explainer::on_array},
    {"not enough data provided for construction", &Explainer::too_few_values},
    {"too many arguments", &Explainer::too_many_values},
    {"Number of constructor parameters", &Explainer::other_field_count},
    {"cannot construct with these arguments", &Explainer::cannot_construct},
    {"Reserved word", &Explainer::reserved},
    {"redefinition", &Explainer::declared_twice},
    {"can't use function syntax on variable", &Explainer::not_a_function},
}};
}  // namespace

void explain(std::vector<CompilerMessage>& messages, const std::string& text,
             const Dialect& dialect) {
    Explainer explainer(text, dialect);
    for (CompilerMessage& message : messages)
        explainer.explain(message);
}
