#include "glsl/limits/large_declarations.h"

#include "glsl/limits/start.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <algorithm>
#include <map>
#include <span>

namespace {
struct StructSize {
    double members = 0.0;
    double depth = 0.0;
};

/// Measures structs and switches in source order.
class DeclarationReader {
public:
    explicit DeclarationReader(std::span<const Token> code) : m_code(code) {}

    /// The first struct or switch that exceeds a limit.
    std::optional<LimitViolation> read(const ShaderLimits& limits) {
        double cases = 0.0;  // since the last `switch`, nested ones included
        while (m_at < m_code.size()) {
            const Token& token = m_code[m_at++];
            if (token.is("switch"))
                cases = 0.0;
            if (token.is("case") && ++cases > limits.switch_cases)
                return LimitViolation{
                    token.line,
                    fmt::format(
                        "this switch has more cases than the limit of {:.0f}. Split it, or raise "
                        "the limit with --limit switch-cases={:.0f}",
                        limits.switch_cases, 2.0 * limits.switch_cases)};
            if (!token.is("struct"))
                continue;
            const StructSize size = read_struct();
            if (size.members > limits.struct_members)
                return LimitViolation{
                    token.line,
                    fmt::format(
                        "this struct has {0:.0f} members; the limit is {1:.0f}. Simplify it, "
                        "or raise the limit with --limit struct-members={0:.0f}",
                        size.members, limits.struct_members)};
            if (size.depth > limits.depth)
                return LimitViolation{
                    token.line,
                    fmt::format(
                        "this struct has {0:.0f} levels of nested structs; the limit is "
                        "{1:.0f}. Simplify it, or raise the limit with --limit depth={0:.0f}",
                        size.depth, limits.depth)};
        }
        return std::nullopt;
    }

private:
    // Parses from after "struct" to after its '}'.
    StructSize read_struct() {
        std::string name;
        while (m_at < m_code.size() && !m_code[m_at].is("{")) {
            if (m_code[m_at].is(";") || m_code[m_at].is(")"))
                return {};
            name = m_code[m_at++].text;
        }
        ++m_at;
        StructSize size;
        while (m_at < m_code.size() && !m_code[m_at].is("}"))
            add_member(size);
        ++m_at;
        size.depth += 1.0;
        return m_known[name] = size;
    }

    // Parses a member declaration up to its ';': its type, and one name per comma.
    void add_member(StructSize& size) {
        StructSize type{1.0, 0.0};
        double names = 1.0;
        int depth = 0;
        while (m_at < m_code.size() && !m_code[m_at].is(";") && !m_code[m_at].is("}")) {
            const Token& token = m_code[m_at++];
            depth += token.is("(") || token.is("[") ? 1 : token.is(")") || token.is("]") ? -1 : 0;
            if (token.is("struct") && m_nested < deepest)
                type = read_nested();
            else if (const auto known = m_known.find(std::string(token.text));
                     known != m_known.end())
                type = known->second;
            else if (token.is(",") && depth == 0)
                names += 1.0;
        }
        if (m_at < m_code.size() && m_code[m_at].is(";"))
            ++m_at;
        size.members += type.members * names;
        size.depth = std::max(size.depth, type.depth);
    }

    StructSize read_nested() {
        ++m_nested;
        const StructSize size = read_struct();
        --m_nested;
        return size;
    }

    static constexpr int deepest = 256;  // maximum nesting of struct declarations, limited by this
                                         // thread's stack
    std::span<const Token> m_code;
    std::size_t m_at = 0;
    int m_nested = 0;
    std::map<std::string, StructSize> m_known;
};

std::optional<LimitViolation> find_in(const std::string& text, const ShaderLimits& limits) {
    const Tokens tokens = scan(text);
    std::vector<Token> code;
    std::ranges::copy_if(tokens.all, std::back_inserter(code), [](const Token& token) {
        return token.kind != Token::Kind::comment && !token.in_directive;
    });
    return DeclarationReader(code).read(limits);
}

// Empty if preprocessing fails; glslang reports the error when it parses the text.
std::string preprocessed(const std::string& text) {
    start_glslang();
    glslang::TShader shader(EShLangFragment);
    const char* const piece = text.c_str();
    shader.setStrings(&piece, 1);
    glslang::TShader::ForbidIncluder no_includes;
    std::string expanded;
    shader.preprocess(GetDefaultResources(), 410, ECoreProfile, false, false, EShMsgDefault,
                      &expanded, no_includes);
    return expanded;
}
}  // namespace

std::optional<LimitViolation> find_large_declaration(const std::string& text,
                                                     const ShaderLimits& limits) {
    if (text.find("struct") == std::string::npos && text.find("case") == std::string::npos)
        return std::nullopt;
    if (auto found = find_in(text, limits))
        return found;
    return find_in(preprocessed(text), limits);
}
