#include "formats/reshade_export/fx_text.h"

#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <vector>

// Reads at the centre of a texel are the same with each filter. A bias or gradient gets its own
// level: OpenGL 4.1, section 3.9.11.
const char* const fx_functions = R"(
uint2 afterglow_size(sampler2D s, uint level, out uint levels)
{
    levels = 1;
    return uint2(tex2Dsize(s, int(level)));
}
float4 afterglow_fetch(sampler2D s, int3 p)
{
    return tex2Dlod(s, float4((float2(p.xy) + 0.5) / float2(tex2Dsize(s, p.z)), 0.0, float(p.z)));
}
float4 afterglow_fetch(sampler2D s, int3 p, int2 offset)
{
    return afterglow_fetch(s, int3(p.xy + offset, p.z));
}
float4 afterglow_grad(sampler2D s, float2 p, float2 dx, float2 dy)
{
    float2 size = float2(tex2Dsize(s, 0));
    float level = log2(max(max(length(dx * size), length(dy * size)), 1e-20));
    return tex2Dlod(s, float4(p, 0.0, level));
}
float4 afterglow_grad(sampler2D s, float2 p, float2 dx, float2 dy, int2 offset)
{
    return afterglow_grad(s, p + float2(offset) / float2(tex2Dsize(s, 0)), dx, dy);
}
float4 afterglow_bias(sampler2D s, float2 p, float bias)
{
    return afterglow_grad(s, p, ddx(p) * exp2(bias), ddy(p) * exp2(bias));
}
float4 afterglow_bias(sampler2D s, float2 p, float bias, int2 offset)
{
    return afterglow_bias(s, p + float2(offset) / float2(tex2Dsize(s, 0)), bias);
}
)";

namespace {
using TokenSpan = std::pair<std::size_t, std::size_t>;  // of tokens
using MemberValues =
    std::vector<std::pair<std::string, std::string>>;  // of a structure, with values

constexpr std::array<std::string_view, 6> wide_matrices{"float2x3", "float2x4", "float3x2",
                                                        "float3x4", "float4x2", "float4x3"};

/// Copies the tokens of an HLSL text with changes.
class FxWriter {
public:
    FxWriter(const std::string& hlsl, bool has_levels)
        : m_hlsl(hlsl), m_tokens(scan(hlsl).all), m_has_levels(has_levels) {}

    FxText write() {
        for (std::size_t at = 0; at < m_tokens.size();)
            at = write_statement(at);
        return {std::move(m_text), std::move(m_obstacle)};
    }

private:
    bool is(std::size_t at, std::string_view word) const {
        return at < m_tokens.size() && m_tokens[at].is(word);
    }
    bool is_word(std::size_t at) const {
        return at < m_tokens.size() && m_tokens[at].kind == Token::Kind::word;
    }
    std::size_t begin_of(std::size_t at) const {
        return at < m_tokens.size()
                   ? static_cast<std::size_t>(m_tokens[at].text.data() - m_hlsl.data())
                   : m_hlsl.size();
    }
    std::size_t end_of(std::size_t at) const { return begin_of(at) + m_tokens[at].text.size(); }

    // The token after the bracket that closes the one at `at`.
    std::size_t after_bracket(std::size_t at) const {
        int depth = 0;
        for (; at < m_tokens.size(); ++at) {
            if (is(at, "(") || is(at, "{") || is(at, "["))
                ++depth;
            else if ((is(at, ")") || is(at, "}") || is(at, "]")) && --depth == 0)
                return at + 1;
        }
        return at;
    }

    // The end of a declaration or function at global scope.
    std::size_t after_statement(std::size_t at) const {
        const bool is_struct = is(at, "struct");
        while (at < m_tokens.size() && !is(at, ";")) {
            const bool is_body = is(at, "{") && !is(at - 1, "=") && !is_struct;
            at = is(at, "(") || is(at, "{") || is(at, "[") ? after_bracket(at) : at + 1;
            if (is_body)
                return at;
        }
        return at + 1;
    }

    std::size_t write_statement(std::size_t at) {
        const std::size_t end = std::min(after_statement(at), m_tokens.size());
        const bool is_declared_by_effect =
            is(at, "uniform") || is(at, "Texture2D") || is(at, "SamplerState") || is(at, "cbuffer");
        const bool is_stage = is(at + 1, "SPIRV_Cross_Input") || is(at + 1, "SPIRV_Cross_Output") ||
                              is(at, "SPIRV_Cross_Output");
        const bool is_query = is(at + 1, "spvTextureSize") || is(at + 1, "SPIRV_Cross_textureSize");
        if (is_declared_by_effect || is_stage || is_query)
            return end;
        if (is(at, "struct"))
            note_struct(at, end);
        if (is(at, "static") && is(at + 1, "const") && note_constant(at + 2))
            return end;
        m_text += rewritten({at, end}) + "\n";
        return end;
    }

    void note_struct(std::size_t at, std::size_t end) {
        std::vector<std::string>& members = m_structs[std::string(m_tokens[at + 1].text)];
        for (std::size_t i = at + 3; i < end; ++i)
            if (is_word(i) && (is(i + 1, ";") || is(i + 1, "[")) && is_word(i - 1))
                members.emplace_back(m_tokens[i].text);
    }

    // static const S name = { a, b };
    bool note_constant(std::size_t at) {
        const auto type = m_structs.find(std::string(m_tokens[at].text));
        if (type == m_structs.end() || !is(at + 2, "="))
            return false;
        MemberValues& members = m_constants[std::string(m_tokens[at + 1].text)];
        const std::vector<std::string> values = arguments_at(at + 3);
        for (std::size_t i = 0; i < std::min(values.size(), type->second.size()); ++i)
            members.emplace_back(type->second[i], values[i]);
        return true;
    }

    // The text of tokens with the space between them.
    std::string rewritten(TokenSpan range) {
        std::string text;
        for (std::size_t at = range.first; at < range.second;) {
            const std::size_t next = write_one(at, range, text);
            if (next < range.second)
                text += m_hlsl.substr(end_of(next - 1), begin_of(next) - end_of(next - 1));
            at = next;
        }
        return text;
    }

    // Writes what starts at a token. Returns the token after it.
    std::size_t write_one(std::size_t at, TokenSpan range, std::string& text) {
        note_obstacles(at);
        if (is_word(at) && is(at + 1, ".") && is_word(at + 2) && is(at + 3, "("))
            if (const char* const function = function_of(at + 2))
                return write_read(at, function, text);
        if (is(at, "Texture2D") && is(at + 1, "<"))
            return write_sampler_type(at, text);
        if (is(at, ",") && is_sampler_argument(at + 1))
            return at + (is(at + 1, "SamplerState") ? 3 : 2);
        if (is(at, "spvTextureSize") || is(at, "SPIRV_Cross_textureSize")) {
            text += "afterglow_size";
            return at + 1;
        }
        if (is(at, "for") && is(at + 2, ";") && is(after_condition(at + 3), ")"))
            return write_while(at, text);
        if (is_word(at) && m_structs.contains(m_tokens[at].text) && is_word(at + 1) &&
            is(at + 2, "=") && is(at + 3, "{") && range.second > at + 4)
            return write_structure(at, text);
        if (is_word(at) && is(at + 1, "=") && is(at + 3, ";") && constant_at(at + 2)) {
            if (at > 0 && is_word(at - 1))  // its declaration
                text += fmt::format("{}; ", m_tokens[at].text);
            text += assignments(m_tokens[at].text, *constant_at(at + 2));
            return at + 4;
        }
        if (const MemberValues* const members = constant_at(at))
            return write_constant(at, *members, text);
        text += m_tokens[at].kind == Token::Kind::number ? number(m_tokens[at].text)
                                                         : std::string(m_tokens[at].text);
        return at + 1;
    }

    void note_obstacles(std::size_t at) {
        const std::string_view word = m_tokens[at].text;
        if (std::ranges::find(wide_matrices, word) != wide_matrices.end())
            m_obstacle = "has matrices that are not square";
        if (!is_word(at) || !is_word(at + 1) || !is(at + 2, "["))
            return;
        if (m_structs.contains(word))
            m_obstacle = "has arrays of structures";
        if (is(after_bracket(at + 2), "[") && !is(at, "return") && !is(at, "else"))
            m_obstacle = "has arrays of arrays";
    }

    // The function for a method of a texture; null for other methods.
    const char* function_of(std::size_t method) {
        const std::string_view name = m_tokens[method].text;
        if (name == "Sample" || name == "SampleLevel")
            return "";
        if (name == "Load")
            return "afterglow_fetch";
        if (name == "SampleBias")
            return "afterglow_bias";
        if (name == "SampleGrad")
            return "afterglow_grad";
        if (name.starts_with("Gather") || name.starts_with("CalculateLevel") ||
            name == "GetDimensions" || name == "SampleCmp")
            m_obstacle = fmt::format("reads a texture by {}()", name);
        return nullptr;
    }

    // The arguments in the brackets that open at a token.
    std::vector<std::string> arguments_at(std::size_t open) {
        std::vector<std::string> arguments;
        const std::size_t close = after_bracket(open) - 1;
        std::size_t begin = open + 1;
        for (std::size_t at = begin; at <= close;) {
            if (at == close || is(at, ",")) {
                if (begin < at)
                    arguments.push_back(rewritten({begin, at}));
                begin = ++at;
            } else {
                at = is(at, "(") || is(at, "[") || is(at, "{") ? after_bracket(at) : at + 1;
            }
        }
        return arguments;
    }

    // The first argument of all methods but Load is the sampler's state.
    std::size_t write_read(std::size_t at, const std::string& function, std::string& text) {
        const std::string texture(m_tokens[at].text);
        const std::string_view method = m_tokens[at + 2].text;
        std::vector<std::string> arguments = arguments_at(at + 3);
        if (method != "Load")
            arguments.erase(arguments.begin());
        // Without derivatives, compilers allow reads in loops and branches.
        if (method == "Sample" && !m_has_levels)
            arguments.insert(arguments.begin() + 1, "0.0");
        const bool has_level = method == "SampleLevel" || (method == "Sample" && !m_has_levels);
        std::string name = function;
        if (name.empty()) {
            const std::size_t plain = has_level ? 2 : 1;
            name = has_level ? "tex2Dlod" : "tex2D";
            if (arguments.size() > plain)
                name += "offset";
            if (has_level) {
                arguments[0] = fmt::format("float4({}, 0.0, {})", arguments[0], arguments[1]);
                arguments.erase(arguments.begin() + 1);
            }
        }
        text += name + "(" + texture;
        for (const std::string& argument : arguments)
            text += ", " + argument;
        text += ")";
        return after_bracket(at + 3);
    }

    // Texture2D<float4> of a function's parameter.
    std::size_t write_sampler_type(std::size_t at, std::string& text) {
        if (!is(at + 2, "float4"))
            m_obstacle = "reads a texture of whole numbers";
        text += "sampler2D";
        return at + 4;
    }

    // The state of a sampler, which is a part of it here.
    bool is_sampler_argument(std::size_t at) const {
        if (!is_word(at))
            return false;
        const std::string_view word = m_tokens[at].text;
        return word == "SamplerState" || (word.starts_with("_") && word.ends_with("_sampler") &&
                                          (is(at + 1, ",") || is(at + 1, ")")));
    }

    // The token after the `;` of a loop's condition.
    std::size_t after_condition(std::size_t at) const {
        while (at < m_tokens.size() && !is(at, ";"))
            at = is(at, "(") || is(at, "[") ? after_bracket(at) : at + 1;
        return at + 1;
    }

    // for (; condition; ), whose empty parts vkBasalt does not read.
    std::size_t write_while(std::size_t at, std::string& text) {
        const std::size_t end = after_condition(at + 3);
        const std::string condition = rewritten({at + 3, end - 1});
        text += fmt::format("while ({})", condition.empty() ? "true" : condition);
        return end + 1;
    }

    // S s = { a, b };
    std::size_t write_structure(std::size_t at, std::string& text) {
        const std::string name(m_tokens[at + 1].text);
        const std::vector<std::string>& members = m_structs.find(m_tokens[at].text)->second;
        const std::vector<std::string> values = arguments_at(at + 3);
        MemberValues assigned;
        for (std::size_t i = 0; i < std::min(values.size(), members.size()); ++i)
            assigned.emplace_back(members[i], values[i]);
        if (text.ends_with("const "))
            text.resize(text.size() - std::string_view("const ").size());
        text += fmt::format("{} {}; {}", m_tokens[at].text, name, assignments(name, assigned));
        return after_bracket(at + 3) + 1;
    }

    static std::string assignments(std::string_view name, const MemberValues& members) {
        std::string text;
        for (const auto& [member, value] : members)
            text += fmt::format("{}{}.{} = {};", text.empty() ? "" : " ", name, member, value);
        return text;
    }

    const MemberValues* constant_at(std::size_t at) const {
        if (!is_word(at))
            return nullptr;
        const auto found = m_constants.find(m_tokens[at].text);
        return found == m_constants.end() ? nullptr : &found->second;
    }

    // A member of a constant structure.
    std::size_t write_constant(std::size_t at, const MemberValues& members, std::string& text) {
        for (const auto& [member, value] : members)
            if (is(at + 1, ".") && is(at + 2, member)) {
                text += fmt::format("({})", value);
                return at + 3;
            }
        m_obstacle = "has constant structures";
        return at + 1;
    }

    // Numbers with many digits in front of the point are not read.
    static std::string number(std::string_view text) {
        constexpr std::size_t most_digits = 9;
        const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
        if (digits <= most_digits || text.find('.') == text.npos)
            return std::string(text);
        double value = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), value);
        return fmt::format("{:.9g}", value);
    }

    const std::string& m_hlsl;
    std::vector<Token> m_tokens;
    bool m_has_levels;
    std::map<std::string, std::vector<std::string>, std::less<>> m_structs;  // their members
    std::map<std::string, MemberValues, std::less<>> m_constants;            // structures
    std::string m_text;
    std::string m_obstacle;
};
}  // namespace

FxText fx_text(const std::string& hlsl, bool has_levels) {
    return FxWriter(hlsl, has_levels).write();
}

std::string fx_string(std::string_view text) {
    std::string quoted = "\"";
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        if (c == '"' || c == '\\')
            quoted += '\\';
        quoted += is_control ? ' ' : c;
        // vkBasalt takes each quote after a backslash for an escaped one.
        if (c == '\\' && (i + 1 == text.size() || text[i + 1] == '"'))
            quoted += ' ';
    }
    return quoted + '"';
}
