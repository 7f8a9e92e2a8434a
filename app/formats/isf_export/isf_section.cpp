#include "formats/isf_export/isf_section.h"

#include "base/text.h"
#include "formats/effect/built_in_value.h"
#include "formats/effect/effect_text.h"
#include "formats/effect/global_values.h"
#include "formats/effect/struct_values.h"
#include "formats/effect/vertex_function.h"
#include "glsl/text/interface_statements.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace {
constexpr auto host_words = std::to_array<std::string_view>(
    {"TIME", "TIMEDELTA", "RENDERSIZE", "PASSINDEX", "FRAMEINDEX", "DATE", "isf_FragNormCoord",
     "isf_vertShaderInit", "gl_FragColor", "inputImage", "IMG_PIXEL", "IMG_NORM_PIXEL",
     "IMG_THIS_PIXEL", "IMG_THIS_NORM_PIXEL", "IMG_SIZE"});

constexpr auto sampling =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"texture", "image_at"},
                                                                  {"textureLod", "image_lod"},
                                                                  {"texelFetch", "image_fetch"},
                                                                  {"textureGather", "image_gather"},
                                                                  {"textureSize", "image_size"},
                                                                  {"sampler2D", "int"}});

/// A function of IsfImages::functions().
struct SamplingFunction {
    std::string_view type;
    std::string_view name;
    std::string_view parameters;
    std::string_view arguments;
};

constexpr auto sampling_functions = std::to_array<SamplingFunction>(
    {{"vec4", "image_at", "int i, vec2 at", "i, at"},
     {"vec4", "image_at", "int i, vec2 at, float bias", "i, at, bias"},
     {"vec4", "image_lod", "int i, vec2 at, float level", "i, at, level"},
     {"vec4", "image_fetch", "int i, ivec2 texel, int level", "i, texel, level"},
     {"vec4", "image_gather", "int i, vec2 at", "i, at"},
     {"vec4", "image_gather", "int i, vec2 at, int component", "i, at, component"},
     {"ivec2", "image_size", "int i, int level", "i, level"}});

constexpr auto refused = std::to_array<std::string_view>(
    {"textureGatherOffset", "textureGatherOffsets", "textureOffset", "textureLodOffset",
     "texelFetchOffset", "textureGrad", "textureProj", "textureProjLod", "textureQueryLod",
     "textureQueryLevels", "samplerCube", "isampler2D", "usampler2D", "sampler3D"});

/// What programs with ISF shaders give to a pass.
class IsfValues final : public HostValues {
public:
    IsfValues(const Pass& pass, const IsfImages& images) : m_pass(pass), m_images(images) {}

    HostSize target() override { return {m_images.drawn_size(m_pass.name)}; }
    // From the size of the pass.
    HostSize output() override {
        const auto factor = [&](std::size_t axis) {
            const Side& side = m_pass.size[axis];
            return side.by == Side::By::viewport ? side.factor : 1.0;
        };
        return {fmt::format("floor(RENDERSIZE / vec2({}, {}) + 0.5)", format_number(factor(0)),
                            format_number(factor(1)))};
    }
    HostSize source() override { return raster(); }
    HostSize raster() override { return {m_images.size_of(m_pass.source)}; }
    HostSize input(const Input& input) override {
        return {m_images.size_of(input.from == Input::From::pass ? input.name : std::string())};
    }
    std::string frames_before() override { return "FRAMEINDEX"; }
    std::string time() override { return fmt::format("(TIME + {})", time_delta()); }
    std::string time_before() override { return "TIME"; }
    // TIMEDELTA is 0 in the first frame.
    std::string time_delta() override { return "(TIMEDELTA > 0.0 ? TIMEDELTA : 1.0 / 60.0)"; }
    std::string date() override { return "DATE"; }

private:
    const Pass& m_pass;
    const IsfImages& m_images;
};

/// Writes the section of one pass.
class SectionWriter {
public:
    SectionWriter(std::size_t pass, const EffectUniforms& uniforms, IsfShared& shared)
        : m_pass(shared.look.passes[pass]), m_uniforms(uniforms), m_shared(shared) {}

    Result<IsfSection> write() {
        auto files = effect_files(m_shared.author, m_pass);
        if (!files)
            return fail(files.error());
        const std::string joined = joined_text(*files);
        if (const std::string word = refused_word(joined); !word.empty())
            return fail({{},
                         0,
                         fmt::format("the pass '{}' uses {}(), which ISF doesn't have. Export it "
                                     "with --to web or --to slang.",
                                     m_pass.name, word)});
        m_rules.words = renamed_built_ins(joined);
        add_words(joined);
        add_values();
        add_images();
        add_input_names(joined, m_rules.words, m_entry.late);
        std::string body = effect_text(joined, m_rules);
        m_entry.globals = take_late_values(body, m_entry.late);
        m_section.text += fmt::format("// Pass {}.\n", m_pass.name) + m_head + body;
        add_vertex();
        m_entry.settings += struct_settings(m_pass, m_structs, m_rules.words, m_vertex_prefix);
        add_entry(joined);
        undefine(joined);
        return std::move(m_section);
    }

private:
    static std::string refused_word(const std::string& text) {
        GlslWords words;
        ::add_words(text, words);
        for (const std::string_view word : refused)
            if (words.contains(word))
                return std::string(word);
        return {};
    }

    // Names that the host or an earlier pass has.
    void add_words(const std::string& joined) {
        for (const auto& [word, other] : sampling)
            m_rules.words[std::string(word)] = other;
        for (const std::string_view word : host_words)
            m_rules.words[std::string(word)] = "own_" + to_lower(word);
        m_rules.words["main"] = "draw_" + m_pass.name;
        for (const std::string& name : global_names(joined)) {
            const std::string wanted = named(name);
            const bool is_free =
                m_shared.globals.insert(wanted).second && !wanted.starts_with("isf_");
            if (is_free)
                continue;
            m_rules.words[name] = own_name(wanted);
            add_sampling(wanted, m_rules.words[name]);
        }
    }

    // A function that has the name of one of GLSL's does not hide it.
    void add_sampling(std::string_view function, const std::string& own) {
        for (const SamplingFunction& of : sampling_functions)
            if (of.name == function)
                m_head += fmt::format("{} {}({}) {{ return {}({}); }}\n", of.type, own,
                                      of.parameters, function, of.arguments);
    }

    // A free name that begins with the pass.
    std::string own_name(const std::string& name) {
        std::string own = m_pass.name + "_" + name;
        while (!m_shared.globals.insert(own).second)
            own += "_2";
        return own;
    }

    std::string named(const std::string& name) const { return renamed_word(m_rules.words, name); }

    void add_values() {
        for (const EffectNumber& number : m_uniforms.numbers) {
            m_rules.declared.insert(number.name);
            add_value(number);
        }
        for (const EffectStruct& of : m_uniforms.structs) {
            std::string members;
            for (const EffectNumber& member : of.members)
                members += (members.empty() ? "" : ", ") + value_of(member);
            m_rules.values[of.name] = "";  // no value where it is declared
            m_entry.late.insert(named(of.name));
            m_structs.push_back({of.name, of.type, members});
        }
    }

    // A parameter of the host, a variable with a fixed value, or one that the entry sets. It is not
    // constant, because compilers check constant indices even where they are not used.
    void add_value(const EffectNumber& number) {
        const auto* parameter = std::get_if<const Parameter*>(&number.setter);
        const IsfControl* control = parameter ? control_of(**parameter) : nullptr;
        if (control && control->is_direct) {
            m_rules.words[number.name] = control->names.front();
            m_entry.late.insert(control->names.front());
            return;
        }
        const std::string type = glsl_name(number.type);
        const std::string name = own_name(named(number.name));
        m_rules.words[number.name] = name;
        m_entry.late.insert(name);
        if (std::holds_alternative<Value>(number.setter)) {
            m_head += fmt::format("{} {} = {};\n", type, name, value_of(number));
            return;
        }
        m_head += fmt::format("{} {};\n", type, name);
        m_entry.settings += fmt::format("    {} = {};\n", name, value_of(number));
    }

    const IsfControl* control_of(const Parameter& parameter) const {
        const auto found = m_shared.controls.find(parameter.name);
        return found == m_shared.controls.end() ? nullptr : &found->second;
    }

    std::string value_of(const EffectNumber& number) const {
        if (const auto* fixed = std::get_if<Value>(&number.setter))
            return glsl_value(number.type, *fixed);
        if (const auto* parameter = std::get_if<const Parameter*>(&number.setter)) {
            const IsfControl* const control = control_of(**parameter);
            return control ? fmt::format("{}({})", glsl_name(number.type),
                                         isf_value(*control, (*parameter)->type))
                           : glsl_zero(number.type);
        }
        if (const auto* built = std::get_if<BuiltInUniform>(&number.setter)) {
            IsfValues values(m_pass, m_shared.images);
            return built_in_value(*built, number.type, m_pass, values);
        }
        return glsl_zero(number.type);
    }

    void add_images() {
        const auto add = [&](const std::string& uniform, std::size_t number) {
            m_rules.declared.insert(uniform);
            const std::string name = own_name(uniform);
            m_rules.words[uniform] = name;
            m_head += fmt::format("const int {} = {};\n", name, number);
        };
        for (const Input& input : m_uniforms.samplers)
            add(input.uniform, m_shared.images.number_of(input));
        constexpr std::size_t nothing = 99;
        for (const std::string& uniform : m_uniforms.unread)
            add(uniform, nothing);
    }

    void add_vertex() {
        if (!has_own_vertex(m_pass))
            return;
        VertexFunction vertex =
            vertex_function(m_pass, m_pass.fragment.text, m_rules, "vertex_" + m_pass.name + "_");
        m_entry.settings += take_late_values(vertex.text, m_entry.late);
        m_section.text += vertex.text;
        m_set_inputs = vertex.name;
        m_vertex_prefix = vertex.prefix;
    }

    // The place in the target, or in the part of it that has the source.
    std::string place() const {
        return m_shared.images.has_source_size(m_pass.name)
                   ? "gl_FragCoord.xy / " + m_shared.images.drawn_size(m_pass.name)
                   : "isf_FragNormCoord";
    }

    // The shader's inputs and outputs are variables.
    void add_entry(const std::string& joined) {
        m_section.entry = "run_" + m_pass.name;
        const ShaderEnds ends = ends_of_shader(joined, m_rules.words);
        m_section.result = ends.output;
        std::string text = fmt::format("\nvoid {}() {{\n{}", m_section.entry, m_entry.settings);
        if (!m_set_inputs.empty())
            text += fmt::format("    {}({});\n", m_set_inputs, place());
        else if (!ends.input.empty())
            text += fmt::format("    {} = {};\n", ends.input, place());
        text += m_entry.globals;
        m_section.text += text + fmt::format("    {}();\n}}\n", named("main"));
    }

    // Macros end with their pass.
    void undefine(const std::string& joined) {
        const Tokens tokens = scan(joined);
        std::set<std::string> macros;
        for (const Directive& directive : find_directives(joined, tokens))
            if (directive.name == "define" && !directive.arguments.empty())
                macros.insert(named(std::string(directive.arguments.front().text)));
        for (const std::string& macro : macros)
            m_section.text += fmt::format("#undef {}\n", macro);
        m_section.text += "\n";
    }

    const Pass& m_pass;
    const EffectUniforms& m_uniforms;
    IsfShared& m_shared;
    EffectTextRules m_rules;
    std::string m_head;  // constants and variables
    EntryValues m_entry;
    std::vector<StructValue> m_structs;
    std::string m_vertex_prefix;  // "": no vertex shader of its own
    std::string m_set_inputs;     // the function of the vertex shader
    IsfSection m_section;
};
}  // namespace

Result<IsfSection> isf_section(std::size_t pass, const EffectUniforms& uniforms,
                               IsfShared& shared) {
    return SectionWriter(pass, uniforms, shared).write();
}
