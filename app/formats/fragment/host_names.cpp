#include "formats/fragment/host_names.h"

#include "glsl/text/tokens.h"

#include <algorithm>
#include <array>
#include <set>

namespace {
/// A name and its declaration; with a chunk, only if that is included.
struct HostName {
    std::string_view name;
    std::string_view declaration;
    std::string_view chunk = {};
};

constexpr auto host_names = std::to_array<HostName>({
    // GameMaker
    {"LOWPREC", "#define LOWPREC"},
    {"gm_BaseTexture", "uniform sampler2D gm_BaseTexture;"},
    {"gm_PS_FogEnabled", "const bool gm_PS_FogEnabled = false;"},
    {"gm_FogColour", "const vec4 gm_FogColour = vec4(0.0, 0.0, 0.0, 1.0);"},
    {"gm_AlphaTestEnabled", "const bool gm_AlphaTestEnabled = false;"},
    {"gm_AlphaRefValue", "const float gm_AlphaRefValue = 0.0;"},
    {"DoAlphaTest", "void DoAlphaTest(vec4 color) {}"},
    {"DoFog", "void DoFog(inout vec4 color, float fog) {}"},
    // three.js
    {"cameraPosition", "const vec3 cameraPosition = vec3(0.0, 0.0, 1.0);"},
    {"viewMatrix", "const mat4 viewMatrix = mat4(1.0);"},
    {"isOrthographic", "const bool isOrthographic = false;"},
    {"linearToOutputTexel", "vec4 linearToOutputTexel(vec4 color) { return color; }"},
    {"PI", "#define PI 3.141592653589793", "common"},
    {"PI2", "#define PI2 6.283185307179586", "common"},
    {"PI_HALF", "#define PI_HALF 1.5707963267948966", "common"},
    {"RECIPROCAL_PI", "#define RECIPROCAL_PI 0.3183098861837907", "common"},
    {"RECIPROCAL_PI2", "#define RECIPROCAL_PI2 0.15915494309189535", "common"},
    {"EPSILON", "#define EPSILON 1e-6", "common"},
    {"saturate", "#define saturate(x) clamp(x, 0.0, 1.0)", "common"},
    {"whiteComplement", "#define whiteComplement(x) (1.0 - clamp(x, 0.0, 1.0))", "common"},
    {"pow2", "float pow2(float x) { return x * x; }", "common"},
    {"pow3", "float pow3(float x) { return x * x * x; }", "common"},
    {"pow4", "float pow4(float x) { return x * x * x * x; }", "common"},
    {"average", "float average(vec3 color) { return dot(color, vec3(1.0 / 3.0)); }", "common"},
    {"luminance", "float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }",
     "common"},
    {"rand", "float rand(vec2 at) { return fract(sin(dot(at, vec2(127.1, 311.7))) * 43758.5); }",
     "common"},
    // The z of a view between near and far (negative), and its depth from 0 to 1, as in GL.
    {"perspectiveDepthToViewZ",
     "float perspectiveDepthToViewZ(float depth, float near, float far) "
     "{ return near * far / ((far - near) * depth - far); }",
     "packing"},
    {"viewZToPerspectiveDepth",
     "float viewZToPerspectiveDepth(float z, float near, float far) "
     "{ return (near + z) * far / ((far - near) * z); }",
     "packing"},
    {"orthographicDepthToViewZ",
     "float orthographicDepthToViewZ(float depth, float near, float far) "
     "{ return depth * (near - far) - near; }",
     "packing"},
    {"viewZToOrthographicDepth",
     "float viewZToOrthographicDepth(float z, float near, float far) "
     "{ return (z + near) / (near - far); }",
     "packing"},
});

// Also lists the chunks that have no effect without fog, clipping or tone mapping.
constexpr auto chunks = std::to_array<std::string_view>({
    "common",
    "packing",
    "clipping_planes_pars_fragment",
    "clipping_planes_fragment",
    "colorspace_pars_fragment",
    "colorspace_fragment",
    "dithering_pars_fragment",
    "dithering_fragment",
    "encodings_pars_fragment",
    "encodings_fragment",
    "fog_pars_fragment",
    "fog_fragment",
    "logdepthbuf_pars_fragment",
    "logdepthbuf_fragment",
    "premultiplied_alpha_fragment",
    "tonemapping_pars_fragment",
    "tonemapping_fragment",
});

/// The names that a text uses, declares and includes.
class NamesOfText {
public:
    explicit NamesOfText(std::string_view text) {
        const Tokens tokens = scan(text);
        for (const Directive& directive : find_directives(text, tokens)) {
            if (directive.arguments.empty())
                continue;
            if (directive.name == "define")
                m_declared.insert(directive.arguments.front().text);
            if (directive.name == "include" && directive.arguments.size() > 1)
                m_chunks.insert(directive.arguments[1].text);
        }
        for (const Token& token : tokens.all)
            if (token.kind != Token::Kind::comment)
                add(token);
    }

    bool needs(const HostName& host) const {
        return m_used.contains(host.name) && !m_declared.contains(host.name) &&
               (host.chunk.empty() || m_chunks.contains(host.chunk));
    }

private:
    // Outside brackets, a name after a word or in a list is a declaration if the next token may
    // follow a name.
    void add(const Token& token) {
        constexpr std::string_view behind_names = ";,=[(";
        if (token.kind == Token::Kind::word)
            m_used.insert(token.text);
        if (token.in_directive)
            return;
        const bool is_word = token.kind == Token::Kind::word;
        if (!is_word && !m_candidate.empty() &&
            behind_names.find(token.text) != std::string_view::npos)
            m_declared.insert(m_candidate);
        const bool is_behind = m_is_behind_word || m_before == ",";
        m_candidate = m_depth == 0 && is_word && is_behind ? token.text : std::string_view();
        const bool opens = token.is("(") || token.is("{") || token.is("[");
        const bool closes = token.is(")") || token.is("}") || token.is("]");
        m_depth = std::max(m_depth + (opens ? 1 : 0) - (closes ? 1 : 0), 0);
        m_is_behind_word = is_word;
        m_before = token.text;
    }

    std::set<std::string_view> m_used;
    std::set<std::string_view> m_declared;
    std::set<std::string_view> m_chunks;
    std::string_view m_before;
    std::string_view m_candidate;
    bool m_is_behind_word = false;
    int m_depth = 0;
};
}  // namespace

std::span<const std::string_view> host_chunks() {
    return chunks;
}

std::string host_declarations(std::string_view text) {
    const NamesOfText names(text);
    std::string declarations;
    for (const HostName& host : host_names)
        if (names.needs(host))
            declarations.append(host.declaration).push_back('\n');
    return declarations;
}
