#include "formats/reshade_export/fx_shader.h"

#include "formats/effect/built_in_value.h"
#include "formats/effect/effect_text.h"
#include "formats/effect/vertex_function.h"
#include "formats/glsl/modern_glsl.h"
#include "formats/reshade_export/fx_text.h"
#include "glsl/hlsl/fragment_hlsl.h"
#include "glsl/text/interface_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace {
// What an effect can't read.
constexpr auto refused = std::to_array<std::string_view>(
    {"textureQueryLod", "textureQueryLevels", "textureGatherOffsets", "samplerCube", "isampler2D",
     "usampler2D", "sampler3D", "sampler2DArray", "sampler2DShadow", "gl_FrontFacing"});

// Words of ReShade FX that are no words of GLSL.
constexpr auto effect_words = std::to_array<std::string_view>(
    {"pass", "technique", "string", "vector", "matrix", "linear", "point", "line", "half",
     "BUFFER_WIDTH", "BUFFER_HEIGHT", "BUFFER_RCP_WIDTH", "BUFFER_RCP_HEIGHT", "BUFFER_PIXEL_SIZE",
     "BUFFER_SCREEN_SIZE", "BUFFER_ASPECT_RATIO", "BUFFER_COLOR_BIT_DEPTH"});

constexpr auto effect_functions = std::to_array<std::string_view>({"lerp",        "frac",
                                                                   "saturate",    "mul",
                                                                   "rcp",         "ddx",
                                                                   "ddy",         "fmod",
                                                                   "log10",       "sincos",
                                                                   "atan2",       "rsqrt",
                                                                   "mad",         "asfloat",
                                                                   "asint",       "asuint",
                                                                   "tex2D",       "tex2Dlod",
                                                                   "tex2Dfetch",  "tex2Dsize",
                                                                   "tex2Doffset", "tex2Dlodoffset",
                                                                   "tex2Dgather"});

// GLSL's order of the four texels.
constexpr const char* gather_functions = R"(
vec4 afterglow_gather_offset(sampler2D s, vec2 p, ivec2 offset, int component) {
    vec2 size = vec2(textureSize(s, 0));
    vec2 low = floor(p * size - 0.5) + vec2(offset) + 0.5;
    return vec4(textureLod(s, (low + vec2(0.0, 1.0)) / size, 0.0)[component],
                textureLod(s, (low + vec2(1.0, 1.0)) / size, 0.0)[component],
                textureLod(s, (low + vec2(1.0, 0.0)) / size, 0.0)[component],
                textureLod(s, low / size, 0.0)[component]);
}
vec4 afterglow_gather_offset(sampler2D s, vec2 p, ivec2 offset) {
    return afterglow_gather_offset(s, p, offset, 0);
}
vec4 afterglow_gather(sampler2D s, vec2 p, int component) {
    return afterglow_gather_offset(s, p, ivec2(0), component);
}
vec4 afterglow_gather(sampler2D s, vec2 p) {
    return afterglow_gather_offset(s, p, ivec2(0), 0);
}
)";

std::string size_name(const std::string& texture) {
    return "afterglow_size_of_" + (texture.empty() ? "the_source" : texture);
}

/// What ReShade gives to a pass. `declared`: declares a value of the effect and returns its name.
class FxHost final : public HostValues {
public:
    using Declared = std::function<std::string(const char* type, const std::string& name)>;
    FxHost(const Pass& pass, Declared declared) : m_pass(pass), m_declared(std::move(declared)) {}

    HostSize target() override { return size_of(m_pass.name); }
    HostSize output() override { return {m_declared("vec2", "afterglow_output")}; }
    HostSize source() override { return raster(); }
    HostSize raster() override { return size_of(m_pass.source); }
    HostSize input(const Input& input) override {
        return size_of(input.from == Input::From::source ? std::string() : input.name);
    }
    std::string frames_before() override { return m_declared("int", "afterglow_frame_count"); }
    std::string time() override { return m_declared("float", "afterglow_time"); }
    std::string time_before() override { return time() + " - " + time_delta(); }
    std::string time_delta() override { return m_declared("float", "afterglow_delta"); }
    std::string date() override { return m_declared("vec4", "afterglow_date"); }

private:
    HostSize size_of(const std::string& texture) {
        return {m_declared("vec2", size_name(texture))};
    }

    const Pass& m_pass;
    Declared m_declared;
};

/// Writes one pass in GLSL, which is then translated.
class ShaderWriter {
public:
    ShaderWriter(std::size_t index, const EffectUniforms& uniforms, FxShared& shared)
        : m_index(index),
          m_pass(shared.look.passes[index]),
          m_uniforms(uniforms),
          m_shared(shared) {}

    Result<FxShader> write() {
        GlslWords words;
        add_words(m_pass.fragment.text, words);
        add_words(m_pass.vertex.text, words);
        for (const std::string_view word : refused)
            if (words.contains(word))
                return refusal(fmt::format("uses {}", word));
        add_rules();
        add_values();
        add_samplers();
        const std::string glsl = glsl_text(words);
        const auto hlsl = fragment_hlsl(glsl, m_pass.fragment.file);
        if (!hlsl)
            return refusal("can't be translated: " + hlsl.error().front().message);
        const bool has_levels = std::ranges::any_of(
            m_uniforms.samplers, [](const Input& input) { return input.sampler.mipmap; });
        FxText fx = fx_text(*hlsl, has_levels);
        if (!fx.obstacle.empty())
            return refusal(fx.obstacle);
        return FxShader{fx_namespace(fx.text), fmt::format("pass_{}::draw", m_pass.name)};
    }

private:
    Result<FxShader> refusal(const std::string& reason) const {
        return fail({{},
                     0,
                     fmt::format("the pass '{}' {}, which ReShade can't do. {}", m_pass.name,
                                 reason, fx_alternative)});
    }

    void add_rules() {
        m_rules.words = renamed_built_ins(m_pass.fragment.text);
        for (const std::string_view word : effect_words)
            m_rules.words.emplace(word, fmt::format("own_{}", word));
        for (const std::string& name : global_names(m_pass.fragment.text))
            if (std::ranges::find(effect_functions, name) != effect_functions.end())
                m_rules.words.emplace(name, "own_" + name);
        m_rules.words["textureGather"] = "afterglow_gather";
        m_rules.words["textureGatherOffset"] = "afterglow_gather_offset";
        m_rules.words["main"] = "afterglow_main";
    }

    std::string named(const std::string& name) const { return renamed_word(m_rules.words, name); }

    void declare(const std::string& type, const std::string& name) {
        if (m_declared.insert(name).second)
            m_head += fmt::format("uniform {} {};\n", type, name);
    }

    void add_values() {
        for (const EffectNumber& number : m_uniforms.numbers) {
            m_rules.declared.insert(number.name);
            m_values += fmt::format("{} {} = {};\n", glsl_name(number.type), named(number.name),
                                    value_of(number));
        }
        for (const EffectStruct& of : m_uniforms.structs) {
            std::string& members = m_rules.values[of.name];
            for (const EffectNumber& member : of.members)
                members += (members.empty() ? "" : ", ") + value_of(member);
        }
    }

    std::string value_of(const EffectNumber& number) {
        if (const auto* fixed = std::get_if<Value>(&number.setter))
            return glsl_value(number.type, *fixed);
        if (const auto* parameter = std::get_if<const Parameter*>(&number.setter)) {
            const auto found = m_shared.controls.find((*parameter)->name);
            if (found == m_shared.controls.end())
                return glsl_zero(number.type);
            declare(glsl_name(found->second.type), found->second.control.id);
            return fx_glsl_value(found->second, number.type);
        }
        if (const auto* built = std::get_if<BuiltInUniform>(&number.setter)) {
            FxHost host(m_pass, [this](const char* of, const std::string& name) {
                declare(of, name);
                return name;
            });
            return built_in_value(*built, number.type, m_pass, host);
        }
        return glsl_zero(number.type);
    }

    void add_samplers() {
        const auto add = [&](const std::string& uniform, const std::string& sampler) {
            m_rules.declared.insert(uniform);
            declare("sampler2D", sampler);
            m_values += fmt::format("#define {} {}\n", named(uniform), sampler);
        };
        for (const Input& input : m_uniforms.samplers)
            add(input.uniform, m_shared.textures.sampler(input, m_index));
        for (const std::string& uniform : m_uniforms.unread)
            add(uniform, m_shared.textures.black());
    }

    // The author's inputs and outputs become variables.
    std::string glsl_text(const GlslWords& words) {
        std::string text = "#version 410 core\n";
        for (const std::string_view stage :
             {std::string_view(m_pass.fragment.text), std::string_view(m_pass.vertex.text)})
            for (const std::string& line : extension_lines(stage))
                if (text.find(line) == text.npos)
                    text += line + "\n";
        text += m_head;
        if (words.contains("textureGather") || words.contains("textureGatherOffset"))
            text += gather_functions;
        text += m_values + effect_text(m_pass.fragment.text, m_rules);
        std::string start;
        if (has_own_vertex(m_pass)) {
            const VertexFunction vertex = vertex_function(m_pass, m_pass.fragment.text, m_rules);
            text += vertex.text;
            start = fmt::format("    {}(afterglow_place);\n", vertex.name);
        }
        std::string output = "vec4(0.0)";
        bool has_output = false;
        for (const InterfaceStatement& statement :
             find_interface_statements(m_pass.fragment.text)) {
            if (statement.declarators.empty())
                continue;
            const std::string name = named(statement.declarators.front().name);
            if (statement.kind == InterfaceStatement::Kind::output && !has_output) {
                output = four_channels(name, statement.type);
                has_output = true;
            }
            if (statement.kind == InterfaceStatement::Kind::input && !has_own_vertex(m_pass) &&
                statement.type == "vec2")
                start += fmt::format("    {} = afterglow_place;\n", name);
        }
        return text +
               fmt::format(
                   "\nlayout(location = 0) in vec2 afterglow_place;\n"
                   "layout(location = 0) out vec4 afterglow_color;\n"
                   "void main() {{\n{}    afterglow_main();\n    afterglow_color = {};\n}}\n",
                   start, output);
    }

    static std::string four_channels(const std::string& name, const std::string& type) {
        return type == "vec3"    ? fmt::format("vec4({}, 1.0)", name)
               : type == "vec2"  ? fmt::format("vec4({}, 0.0, 1.0)", name)
               : type == "float" ? fmt::format("vec4({}, 0.0, 0.0, 1.0)", name)
                                 : name;
    }

    // The place in the screen that the first pass copies from.
    std::string place() const {
        const auto input = std::ranges::find(m_pass.inputs, Input::From::source, &Input::from);
        if (input == m_pass.inputs.end())
            return "place";
        return m_shared.look.source_rows == RowOrder::bottom_first
                   ? "afterglow_upright(afterglow_content(afterglow_upright(place)))"
                   : "afterglow_content(place)";
    }

    std::string fx_namespace(const std::string& body) const {
        std::string text = fmt::format(
            "\nnamespace pass_{}\n{{\n{}\n"
            "float4 draw(float4 position : SV_Position, float2 place : TEXCOORD) : SV_Target\n{{\n",
            m_pass.name, body);
        if (body.find("gl_FragCoord") != body.npos)
            text += "    gl_FragCoord = float4(position.xy, 0.5, 1.0);\n";
        if (body.find("static float2 afterglow_place") != body.npos)
            text += fmt::format("    afterglow_place = {};\n", place());
        return text + "    frag_main();\n    return afterglow_color;\n}\n}\n";
    }

    std::size_t m_index;
    const Pass& m_pass;
    const EffectUniforms& m_uniforms;
    FxShared& m_shared;
    EffectTextRules m_rules;
    std::set<std::string> m_declared;  // uniforms
    std::string m_head;                // their declarations
    std::string m_values;
};
}  // namespace

Result<FxShader> fx_shader(std::size_t pass, const EffectUniforms& uniforms, FxShared& shared) {
    return ShaderWriter(pass, uniforms, shared).write();
}

std::string fx_built_ins(const Look& look, const FxTextures& textures) {
    std::string text = R"(
uniform int afterglow_frame_count < source = "framecount"; >;
uniform float afterglow_timer < source = "timer"; >;
uniform float afterglow_frame_time < source = "frametime"; >;
uniform float4 afterglow_date < source = "date"; >;
#if AFTERGLOW_FRAME_RATE > 0
    #define afterglow_time (float(afterglow_frame_count + 1) / float(AFTERGLOW_FRAME_RATE))
    #define afterglow_delta (1.0 / float(AFTERGLOW_FRAME_RATE))
#else
    #define afterglow_time (afterglow_timer * 0.001)
    #define afterglow_delta (afterglow_frame_time * 0.001)
#endif

static const float2 afterglow_output = float2(afterglow_width, afterglow_height);
)";
    const auto add = [&](const std::string& name) {
        const FxSize size = textures.size_of(name);
        text += fmt::format("static const float2 {} = float2({}, {});\n", size_name(name),
                            size.width, size.height);
    };
    add("");
    for (const Pass& pass : look.passes)
        add(pass.name);
    for (const Image& image : look.images)
        add(image.name);
    return text;
}
