#include "glsl/es/es_source.h"

#include "base/text.h"
#include "glsl/es/es_functions.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace {
EsWrap border_of(const Sampler& sampler) {
    return sampler.filter == Filter::linear ? EsWrap::linear_border : EsWrap::nearest_border;
}

EsWrap wrap_of(const Sampler& sampler) {
    switch (sampler.wrap) {
        case Wrap::edge:
            return EsWrap::edge;
        case Wrap::repeat:
            return EsWrap::repeat;
        case Wrap::mirror:
            return EsWrap::mirror;
        case Wrap::border:
            return border_of(sampler);
    }
    return EsWrap::edge;
}

// How a sampler wraps, with its levels.
int wrap_number(const Sampler& sampler) {
    const int wrap = static_cast<int>(wrap_of(sampler));
    if (!sampler.mipmap)
        return wrap;
    const bool mixes = sampler.between_levels.value_or(sampler.filter) == Filter::linear;
    return wrap + es_mipmapped + (mixes ? es_mixes_levels : 0);
}

const EsFunction* find_function(std::string_view name) {
    const auto found = std::ranges::find(es_functions, name, &EsFunction::name);
    return found == es_functions.end() ? nullptr : &*found;
}

// Functions that read no filtered texels, so they need not know how a sampler wraps.
bool reads_texels_only(std::string_view name) {
    return std::ranges::find(es_texel_functions, name) != es_texel_functions.end();
}

// Of flat pictures.
bool is_sampler_type(const Token& token) {
    return token.is("sampler2D") || token.is("isampler2D") || token.is("usampler2D");
}

/// Which names stand for a sampler of a flat picture at a token of a text.
class SamplerScope {
public:
    explicit SamplerScope(const std::vector<Token>& tokens) : m_tokens(tokens) {}

    /// Call for each token in turn.
    void enter(std::size_t at);
    void add_uniform(std::size_t at) { m_uniforms.insert(m_tokens[at].text); }

    bool is_global() const { return m_braces == 0; }
    /// The function whose brackets are open; "" for other brackets and without any.
    std::string_view callee() const {
        return m_callees.empty() ? std::string_view() : m_callees.back();
    }
    /// Whether the token opens the body of a function.
    bool opens_body(std::size_t at) const {
        return m_braces == 1 && at > 0 && is(at, "{") && is(at - 1, ")");
    }
    /// Whether the token declares a sampler parameter of a function.
    bool declares_parameter(std::size_t at) const {
        return m_braces == 0 && !m_callees.empty() && is_sampler_type(m_tokens[at - 1]) &&
               (is(at + 1, ",") || is(at + 1, ")"));
    }
    bool is_sampler(std::string_view name) const {
        return m_parameters.contains(name) ||
               (m_uniforms.contains(name) && !m_locals.contains(name));
    }

private:
    bool is(std::size_t at, std::string_view word) const {
        return at < m_tokens.size() && m_tokens[at].is(word);
    }
    void leave_brace();
    bool declares_local(std::size_t at) const;

    const std::vector<Token>& m_tokens;
    std::vector<std::string_view> m_callees;   // of the open brackets
    std::set<std::string_view> m_uniforms;     // samplers
    std::set<std::string_view> m_parameters;   // samplers, of the current function
    std::map<std::string_view, int> m_locals;  // other variables in scope, with their depth
    int m_braces = 0;
};

void SamplerScope::enter(std::size_t at) {
    if (is(at, "{"))
        ++m_braces;
    else if (is(at, "}"))
        leave_brace();
    else if (is(at, "("))
        m_callees.push_back(at > 0 && m_tokens[at - 1].kind == Token::Kind::word
                                ? m_tokens[at - 1].text
                                : std::string_view());
    else if (is(at, ")") && !m_callees.empty())
        m_callees.pop_back();
    else if (m_braces == 0 && is(at, ";")) {
        m_parameters.clear();
        m_locals.clear();
    } else if (m_tokens[at].kind == Token::Kind::word && at > 0) {
        if (declares_parameter(at))
            m_parameters.insert(m_tokens[at].text);
        else if (declares_local(at))
            m_locals.emplace(m_tokens[at].text, std::max(m_braces, 1));
    }
}

void SamplerScope::leave_brace() {
    --m_braces;
    std::erase_if(m_locals, [&](const auto& local) { return local.second > m_braces; });
    if (m_braces == 0)
        m_parameters.clear();
}

// "TYPE name" of a local variable or a parameter.
bool SamplerScope::declares_local(std::size_t at) const {
    constexpr std::array statements{"return", "else", "do", "case"};
    const bool has_type = m_tokens[at - 1].kind == Token::Kind::word &&
                          std::ranges::none_of(statements, [&](std::string_view statement) {
                              return is(at - 1, statement);
                          });
    return has_type && !is(at + 1, "(") && (m_braces > 0 || !m_callees.empty());
}

/// Copies the tokens of a text with changes.
class EsWriter {
public:
    EsWriter(const std::string& text, const std::map<std::string, Sampler>& samplers,
             const EsStage& stage)
        : m_text(text), m_samplers(samplers), m_scope(m_tokens), m_stage(stage) {
        for (const Token& token : scan(text).all)
            if (token.kind != Token::Kind::comment && !token.in_directive)
                m_tokens.push_back(token);
        m_has_border = std::ranges::any_of(
            samplers, [](const auto& item) { return item.second.wrap == Wrap::border; });
        m_mixes_border = std::ranges::any_of(samplers, [](const auto& item) {
            return item.second.wrap == Wrap::border && item.second.mipmap;
        });
        m_passes_wraps =
            m_has_border || std::ranges::any_of(es_functions, [&](const auto& function) {
                return function.reads_sampler && !function.is_of_border && names(function.name);
            });
    }

    std::string write();

private:
    bool names(std::string_view function) const {
        return std::ranges::find(m_tokens, function, &Token::text) != m_tokens.end();
    }
    bool is(std::size_t at, std::string_view word) const {
        return at < m_tokens.size() && m_tokens[at].is(word);
    }
    std::size_t begin_of(std::size_t at) const {
        return static_cast<std::size_t>(m_tokens[at].text.data() - m_text.data());
    }

    void note_uniform_statement(std::size_t at);
    void copy_until(std::size_t offset);
    void replace(std::size_t at, const std::string& text);
    std::size_t skip_initialiser(std::size_t at);
    void note_sampler(std::size_t at);
    void write_word(std::size_t at);
    std::string border_functions() const;
    std::string functions() const;

    const std::string& m_text;
    const std::map<std::string, Sampler>& m_samplers;
    std::vector<Token> m_tokens;
    SamplerScope m_scope;
    std::string m_declared;             // constants for the uniforms
    std::set<std::string_view> m_used;  // replaced functions
    std::string m_result;
    std::size_t m_copied = 0;
    EsStage m_stage;
    bool m_is_in_uniform = false;     // statement
    bool m_declares_sampler = false;  // of a flat picture
    bool m_has_border = false;
    bool m_mixes_border = false;  // and mip levels
    bool m_passes_wraps = false;
};

void EsWriter::copy_until(std::size_t offset) {
    m_result.append(m_text, m_copied, offset - m_copied);
    m_copied = offset;
}

void EsWriter::replace(std::size_t at, const std::string& text) {
    copy_until(begin_of(at));
    m_result += text;
    m_copied = begin_of(at) + m_tokens[at].text.size();
}

// Drops the tokens from '=' up to the end of a declared name; returns the index of that end.
std::size_t EsWriter::skip_initialiser(std::size_t at) {
    copy_until(begin_of(at));
    for (int depth = 0; at < m_tokens.size(); ++at) {
        if (is(at, "(") || is(at, "[") || is(at, "{"))
            ++depth;
        else if (is(at, ")") || is(at, "]") || is(at, "}"))
            --depth;
        else if (depth == 0 && (is(at, ",") || is(at, ";")))
            break;
    }
    m_copied = at < m_tokens.size() ? begin_of(at) : m_text.size();
    return at;
}

void EsWriter::note_sampler(std::size_t at) {
    const std::string name(m_tokens[at].text);
    m_scope.add_uniform(at);
    const auto found = m_samplers.find(name);
    const int wrap = found == m_samplers.end() ? 0 : wrap_number(found->second);
    m_declared += fmt::format("const int {}_es_wrap = {};\n", name, wrap);
}

void EsWriter::write_word(std::size_t at) {
    const std::string_view word = m_tokens[at].text;
    const EsFunction* function = is(at + 1, "(") ? find_function(word) : nullptr;
    // A read of another type of sampler keeps its function.
    const bool has_sampler =
        function && at + 2 < m_tokens.size() && m_scope.is_sampler(m_tokens[at + 2].text);
    if (function && (function->reads_sampler ? has_sampler : true) &&
        (m_has_border || !function->is_of_border)) {
        replace(at, std::string(function->replaced));
        m_used.insert(function->name);
        return;
    }
    if (!m_passes_wraps || at == 0)
        return;
    if (m_scope.declares_parameter(at)) {
        replace(at, fmt::format("{0}, int {0}_es_wrap", word));
        return;
    }
    const bool is_argument =
        (is(at - 1, "(") || is(at - 1, ",")) && (is(at + 1, ",") || is(at + 1, ")"));
    if (!is_argument || !m_scope.is_sampler(word))
        return;
    const std::string_view callee = m_scope.callee();
    const EsFunction* called = find_function(callee);
    const bool is_unchanged =
        called ? called->is_of_border && !m_has_border : reads_texels_only(callee);
    if (!callee.empty() && !is_unchanged)
        replace(at, fmt::format("{0}, {0}_es_wrap", word));
}

// For pictures and numbers of both kinds.
std::string of_integers(std::string_view functions) {
    return replace_all(std::string(functions), "NUMBERS", "i") +
           replace_all(std::string(functions), "NUMBERS", "u");
}

std::string EsWriter::border_functions() const {
    std::string text(es_border_functions);
    if (m_mixes_border) {
        text += es_mipmap_functions;
        text += m_stage.is_fragment ? es_fragment_mipmap_functions : es_vertex_mipmap_functions;
        text += es_mipmap_offset_function;
    } else {
        text += es_flat_functions;
        text += m_stage.is_fragment ? es_flat_bias_function : std::string_view();
    }
    text += es_composed_functions;
    text += m_stage.is_fragment ? es_bias_functions : std::string_view();
    return text + of_integers(es_integer_border_functions);
}

std::string EsWriter::functions() const {
    const auto uses = [&](std::string_view part) {
        return std::ranges::any_of(
            m_used, [&](std::string_view name) { return name.find(part) != name.npos; });
    };
    std::string text;
    if (m_stage.is_impure)
        text += "int es_touched;\n";
    if (uses("Gather"))
        text += es_gather_functions;
    if (m_mixes_border || uses("Query"))
        text += es_level_functions;
    if (uses("Query") && m_stage.is_fragment)
        text += es_fragment_level_functions;
    if (m_has_border)
        text += border_functions();
    if (uses("bit") || uses("find"))
        text += std::string(es_bit_functions) + of_integers(es_bit_vector_functions);
    if (uses("pack") || uses("ldexp"))
        text += es_pack_functions;
    return text + m_declared;
}

void EsWriter::note_uniform_statement(std::size_t at) {
    if (!m_scope.is_global())
        return;
    if (is(at, "uniform"))
        m_is_in_uniform = true;
    else if (is(at, ";"))
        m_is_in_uniform = m_declares_sampler = false;
    else if (m_is_in_uniform && is_sampler_type(m_tokens[at]))
        m_declares_sampler = true;
    else if (m_declares_sampler && m_tokens[at].kind == Token::Kind::word &&
             (is(at + 1, ",") || is(at + 1, ";")))
        note_sampler(at);
}

std::string EsWriter::write() {
    const std::size_t start = m_tokens.empty() ? m_text.size() : begin_of(0);
    copy_until(start);
    for (std::size_t at = 0; at < m_tokens.size(); ++at) {
        m_scope.enter(at);
        note_uniform_statement(at);
        if (m_is_in_uniform && m_scope.is_global() && is(at, "="))
            at = skip_initialiser(at) - 1;
        else if (m_tokens[at].kind == Token::Kind::word && !m_is_in_uniform)
            write_word(at);
        else if (m_stage.is_impure && m_scope.opens_body(at))
            replace(at, "{ es_touched = 0;");
    }
    copy_until(m_text.size());
    return m_result.insert(start, functions());
}
}  // namespace

std::string es_source(const std::string& preprocessed,
                      const std::map<std::string, Sampler>& samplers, const EsStage& stage) {
    return EsWriter(preprocessed, samplers, stage).write();
}
