#include "glsl/text/shader_names.h"

#include "glsl/text/tokens.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace {
constexpr auto short_keywords =
    std::to_array<std::string_view>({"if", "for", "do", "in", "out", "asm"});

bool is_keyword(std::string_view word) {
    return std::ranges::find(short_keywords, word) != short_keywords.end() ||
           std::ranges::find(glsl_keywords(), word) != glsl_keywords().end();
}

// The last of that name.
template <class Named>
const Named* find_last(const std::vector<Named>& all, std::string_view name) {
    const auto found = std::find_if(all.rbegin(), all.rend(),
                                    [name](const Named& one) { return one.name == name; });
    return found == all.rend() ? nullptr : &*found;
}

/// Reads declarations and tracks blocks.
class NameReader {
public:
    NameReader(std::string_view text, int line) : m_line(line) {
        const Tokens tokens = scan(text);
        for (const Directive& directive : find_directives(text, tokens))
            if (directive.name == "define" && !directive.arguments.empty() &&
                directive.line <= line)
                m_names.macros.emplace_back(directive.arguments.front().text);
        for (const Token& token : tokens.all)
            if (token.kind != Token::Kind::comment && !token.in_directive && token.line <= line)
                m_tokens.push_back(token);
    }

    ShaderNames read() {
        while (m_at < m_tokens.size())
            step();
        return std::move(m_names);
    }

private:
    bool has(std::size_t ahead) const { return m_at + ahead < m_tokens.size(); }
    bool is(std::size_t ahead, std::string_view text) const {
        return has(ahead) && m_tokens[m_at + ahead].is(text);
    }
    bool is_word(std::size_t ahead) const {
        return has(ahead) && m_tokens[m_at + ahead].kind == Token::Kind::word;
    }
    std::string text(std::size_t ahead) const { return std::string(m_tokens[m_at + ahead].text); }

    void step() {
        if (is(0, "{"))
            open_block();
        else if (is(0, "}"))
            close_block();
        else if (is(0, "struct"))
            read_struct();
        else if (is_word(0) && !is_keyword(m_tokens[m_at].text))
            read_words();
        else
            ++m_at;
    }

    void open_block() {
        m_blocks.push_back(m_names.variables.size());
        m_names.variables.insert(m_names.variables.end(), m_parameters.begin(), m_parameters.end());
        m_parameters.clear();
        ++m_at;
    }

    void close_block() {
        if (!m_blocks.empty()) {
            if (m_tokens[m_at].line < m_line)
                m_names.variables.resize(m_blocks.back());
            m_blocks.pop_back();
        }
        ++m_at;
    }

    // At a word that is not a keyword: a type before a name, a block, or a part of an expression.
    void read_words() {
        const bool is_after_dot = m_at > 0 && m_tokens[m_at - 1].is(".");
        if (!is_after_dot && m_blocks.empty() && is(1, "{"))
            return read_interface_block();
        const std::size_t name = 1 + size_of_brackets(1);
        if (is_after_dot || !is_word(name) || is_keyword(m_tokens[m_at + name].text)) {
            ++m_at;
            return;
        }
        const std::string type = text(0);
        m_at += name;
        if (is(1, "(") && m_blocks.empty())
            read_function(type);
        else
            read_declarators(type, m_names.variables);
    }

    // The number of tokens of "[3][2]".
    std::size_t size_of_brackets(std::size_t ahead) const {
        const std::size_t start = ahead;
        while (is(ahead, "[")) {
            while (has(ahead) && !is(ahead, "]") && !is(ahead, ";") && !is(ahead, "{"))
                ++ahead;
            if (is(ahead, "]"))
                ++ahead;
        }
        return ahead - start;
    }

    // From the first name to after the ';', or to the bracket that ends the statement.
    void read_declarators(const std::string& type, std::vector<TypedName>& variables) {
        while (is_word(0)) {
            variables.push_back({text(0), type});
            ++m_at;
            skip_initialiser();
            if (!is(0, ","))
                return;
            ++m_at;
        }
    }

    // To the ',' or ';' after an initialiser.
    void skip_initialiser() {
        int depth = 0;
        for (; has(0); ++m_at) {
            if (is(0, "(") || is(0, "[") || (depth > 0 && is(0, "{")))
                ++depth;
            else if (is(0, ")") || is(0, "]"))
                --depth;
            if (depth < 0 || is(0, ";") || is(0, "{") || is(0, "}") || (depth == 0 && is(0, ",")))
                return;
        }
    }

    // At the name of a function.
    void read_function(const std::string& type) {
        FunctionName function{text(0), type, {}};
        m_at += 2;
        m_parameters.clear();
        while (has(0) && !is(0, ")") && !is(0, "{") && !is(0, ";")) {
            if (is_word(0) && !is_keyword(m_tokens[m_at].text)) {
                function.parameters.push_back(text(0));
                const std::size_t name = 1 + size_of_brackets(1);
                if (is_word(name))
                    m_parameters.push_back({text(name), text(0)});
                skip_parameter();
            } else {
                ++m_at;
            }
        }
        if (function.parameters == std::vector<std::string>{"void"})
            function.parameters.clear();
        m_names.functions.push_back(std::move(function));
        if (is(0, ")") && is(1, ";"))
            m_parameters.clear();
    }

    void skip_parameter() {
        while (has(0) && !is(0, ",") && !is(0, ")") && !is(0, "{") && !is(0, ";"))
            ++m_at;
    }

    // At the name of a uniform block, or of an interface between stages.
    void read_interface_block() {
        StructName block{text(0), {}};
        ++m_at;
        block.fields = read_fields();
        if (is_word(0))
            read_declarators(block.name, m_names.variables);
        else
            m_names.variables.insert(m_names.variables.end(), block.fields.begin(),
                                     block.fields.end());
        m_names.structs.push_back(std::move(block));
    }

    void read_struct() {
        ++m_at;
        StructName found;
        if (is_word(0)) {
            found.name = text(0);
            ++m_at;
        }
        if (!is(0, "{"))
            return;
        found.fields = read_fields();
        if (is_word(0))
            read_declarators(found.name, m_names.variables);
        m_names.structs.push_back(std::move(found));
    }

    // From the '{' to after the '}'.
    std::vector<TypedName> read_fields() {
        std::vector<TypedName> fields;
        for (++m_at; has(0) && !is(0, "}");) {
            const std::size_t name = 1 + size_of_brackets(1);
            if (is_word(0) && !is_keyword(m_tokens[m_at].text) && is_word(name)) {
                const std::string type = text(0);
                m_at += name;
                read_declarators(type, fields);
            } else {
                ++m_at;
            }
        }
        ++m_at;
        return fields;
    }

    int m_line;
    std::vector<Token> m_tokens;
    std::size_t m_at = 0;
    std::vector<std::size_t> m_blocks;    // variables visible outside each open block
    std::vector<TypedName> m_parameters;  // of the function whose body follows
    ShaderNames m_names;
};
}  // namespace

const TypedName* ShaderNames::find_variable(std::string_view name) const {
    return find_last(variables, name);
}

const FunctionName* ShaderNames::find_function(std::string_view name) const {
    return find_last(functions, name);
}

const StructName* ShaderNames::find_struct(std::string_view name) const {
    return find_last(structs, name);
}

ShaderNames names_at(std::string_view text, int line) {
    return NameReader(text, line).read();
}

bool is_glsl_type(std::string_view word) {
    return std::ranges::find(common_glsl_types(), word) != common_glsl_types().end();
}

const std::vector<std::string>& common_glsl_types() {
    static const std::vector<std::string> types{
        "float",
        "vec2",
        "vec3",
        "vec4",
        "int",
        "ivec2",
        "ivec3",
        "ivec4",
        "uint",
        "uvec2",
        "uvec3",
        "uvec4",
        "bool",
        "bvec2",
        "bvec3",
        "bvec4",
        "double",
        "dvec2",
        "dvec3",
        "dvec4",
        "mat2",
        "mat3",
        "mat4",
        "mat2x3",
        "mat2x4",
        "mat3x2",
        "mat3x4",
        "mat4x2",
        "mat4x3",
        "void",
        "sampler1D",
        "sampler2D",
        "sampler3D",
        "samplerCube",
        "sampler2DArray",
        "isampler2D",
        "isampler3D",
        "usampler2D",
        "usampler3D",
        "sampler2DShadow",
        "sampler2DMS",
        "samplerRect",
        "sampler1DShadow",
        "sampler1DArray",
        "samplerBuffer",
    };
    return types;
}

const std::vector<std::string>& glsl_keywords() {
    // GLSL 4.10.6, section 3.6 "Keywords".
    static const std::vector<std::string> keywords{
        "attribute", "const",   "uniform",   "varying",    "layout",  "centroid",      "flat",
        "smooth",    "sample",  "patch",     "subroutine", "inout",   "noperspective", "break",
        "continue",  "while",   "switch",    "case",       "default", "else",          "true",
        "false",     "discard", "return",    "lowp",       "mediump", "highp",         "precision",
        "struct",    "precise", "invariant",
    };
    return keywords;
}
