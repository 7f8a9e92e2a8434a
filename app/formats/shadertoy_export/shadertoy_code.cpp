#include "formats/shadertoy_export/shadertoy_code.h"

#include "base/text.h"
#include "formats/effect/built_in_value.h"
#include "formats/effect/effect_files.h"
#include "formats/effect/effect_text.h"
#include "formats/effect/vertex_function.h"
#include "glsl/text/declarations.h"
#include "glsl/text/interface_statements.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace {
constexpr auto site_words = std::to_array<std::string_view>(
    {"iResolution", "iTime", "iGlobalTime", "iTimeDelta", "iFrameRate", "iFrame", "iChannelTime",
     "iChannelResolution", "iMouse", "iDate", "iSampleRate", "iChannel0", "iChannel1", "iChannel2",
     "iChannel3", "mainImage", "HW_PERFORMANCE"});

constexpr auto function_words = std::to_array<std::string_view>(
    {"image_at", "image_lod", "image_fetch", "image_size", "display_to_linear", "bordered",
     "level_at", "level_size", "last_level", "first_level", "level_place", "level_tap",
     "level_texel", "base_texel", "read_level", "stored", "draw_pass", "shadertoy_color",
     "shadertoy_place"});

constexpr auto site_sampling =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"texture", "image_at"},
                                                                  {"textureLod", "image_lod"},
                                                                  {"texelFetch", "image_fetch"},
                                                                  {"textureSize", "image_size"},
                                                                  {"sampler2D", "int"}});

constexpr auto unusable = std::to_array<std::string_view>(
    {"textureGather", "textureOffset", "textureLodOffset", "texelFetchOffset", "textureGrad",
     "textureProj", "textureProjLod", "textureQueryLod", "textureQueryLevels", "samplerCube",
     "isampler2D", "usampler2D", "sampler3D"});

/// What Shadertoy gives to a pass.
class ShadertoyValues final : public HostValues {
public:
    ShadertoyValues(const Pass& pass, bool is_last, ShadertoyImages& images)
        : m_pass(pass), m_is_last(is_last), m_images(images) {}

    HostSize target() override {
        return {m_is_last ? "iResolution.xy" : m_images.size_of(m_pass.name)};
    }
    HostSize output() override { return {"iResolution.xy"}; }
    HostSize source() override { return raster(); }
    HostSize raster() override { return {m_images.size_of(m_pass.source)}; }
    HostSize input(const Input& input) override {
        return {m_images.size_of(input.from == Input::From::pass ? input.name : std::string())};
    }
    std::string frames_before() override { return "iFrame"; }
    std::string time() override { return "(iTime + iTimeDelta)"; }
    std::string time_before() override { return "iTime"; }
    std::string time_delta() override { return "iTimeDelta"; }
    std::string date() override { return "(iDate + vec4(0.0, 1.0, 0.0, 0.0))"; }

private:
    const Pass& m_pass;
    bool m_is_last;
    ShadertoyImages& m_images;
};

// What a format with few bits or channels stores.
std::string stored_value(Format format) {
    constexpr const char* rounded = "floor(clamp(color, 0.0, 1.0) * 255.0 + 0.5) * (1.0 / 255.0)";
    switch (format) {
        case Format::r8:
            return fmt::format("vec4(({}).r, 0.0, 0.0, 1.0)", rounded);
        case Format::rg8:
            return fmt::format("vec4(({}).rg, 0.0, 1.0)", rounded);
        case Format::rgba8:
            return rounded;
        case Format::r16f:
        case Format::r32f:
            return "vec4(color.r, 0.0, 0.0, 1.0)";
        case Format::rg16f:
        case Format::rg32f:
            return "vec4(color.rg, 0.0, 1.0)";
        case Format::r11f_g11f_b10f:
            return "vec4(max(color.rgb, 0.0), 1.0)";
        default:
            return {};
    }
}

// Whether a call of texture() has three arguments.
bool calls_with_bias(std::string_view text) {
    const Tokens tokens = scan(text);
    for (std::size_t i = 0; i + 1 < tokens.all.size(); ++i) {
        if (!tokens.all[i].is("texture") || !tokens.all[i + 1].is("("))
            continue;
        int depth = 0;
        int commas = 0;
        for (std::size_t k = i + 1; k < tokens.all.size(); ++k) {
            const Token& token = tokens.all[k];
            depth += token.is("(") || token.is("[") ? 1 : token.is(")") || token.is("]") ? -1 : 0;
            commas += depth == 1 && token.is(",") ? 1 : 0;
            if (depth == 0)
                break;
        }
        if (commas > 1)
            return true;
    }
    return false;
}

/// Writes the code of one pass.
class CodeWriter {
public:
    CodeWriter(std::size_t pass, const EffectUniforms& uniforms, const ShadertoyShared& shared,
               ShadertoyImages& images)
        : m_pass(shared.plan.look.passes[pass]),
          m_is_last(pass + 1 == shared.plan.look.passes.size()),
          m_uniforms(uniforms),
          m_shared(shared),
          m_images(images) {}

    Result<std::string> write() {
        auto files = effect_files(m_shared.author, m_pass);
        if (!files)
            return fail(files.error());
        m_joined = joined_text(*files);
        GlslWords words;
        add_words(m_joined, words);
        if (has_own_vertex(m_pass))
            add_words(m_pass.vertex.text, words);
        for (const std::string_view word : unusable)
            if (words.contains(word))
                return fail({{},
                             0,
                             fmt::format("the pass '{}' uses {}(), which Shadertoy's passes can't "
                                         "do here. Export it with --to web.",
                                         m_pass.name, word)});
        if (info_of(m_pass.format).format == Format::srgb8_alpha8 ||
            info_of(m_pass.format).format == Format::rgb10_a2)
            return fail({{},
                         0,
                         fmt::format("the pass '{}' rounds its texels to {}, which Shadertoy's "
                                     "buffers don't do. Export it with --to web.",
                                     m_pass.name, info_of(m_pass.format).name)});
        change_words();
        add_values();
        add_images();
        const std::string body = std::string(trim(effect_text(m_joined, m_rules))) + "\n";
        const std::string vertex = vertex_text();
        set_structs();
        const std::string entry = entry_text();
        return m_images.functions(words, calls_with_bias(m_joined)) +
               (m_head.empty() ? "" : "\n" + m_head) + "\n" + body + vertex + entry;
    }

private:
    // Names of the site and of our functions.
    void change_words() {
        m_rules.words = renamed_built_ins(m_joined);
        for (const auto& [word, other] : site_sampling)
            m_rules.words[std::string(word)] = other;
        m_rules.words["main"] = "draw_pass";
        const std::set<std::string, std::less<>> reserved = shadertoy_reserved_names();
        const auto is_taken = [&](const std::string& name) {
            return reserved.contains(name) || name.starts_with("size_of_") ||
                   name.starts_with("read_") || name.starts_with("texel_") ||
                   is_constant_of_another(name);
        };
        for (const std::string& name : global_names(m_joined))
            if (is_taken(name) && !m_rules.words.contains(name))
                m_rules.words[name] = "own_" + name;
    }

    // Common has constants of all passes.
    bool is_constant_of_another(const std::string& name) const {
        for (const std::string& parameter : m_shared.in_common) {
            const ShadertoyConstant& constant = m_shared.constants.at(parameter);
            const bool is_its_name =
                name == constant.control.id ||
                std::ranges::find(constant.names, name) != constant.names.end();
            const bool is_uniform = std::ranges::any_of(
                m_uniforms.numbers,
                [&](const EffectNumber& number) { return number.name == name; });
            if (is_its_name && !is_uniform)
                return true;
        }
        return false;
    }

    std::string named(const std::string& name) const {
        const auto word = m_rules.words.find(name);
        return word == m_rules.words.end() ? name : word->second;
    }

    void add_values() {
        for (const EffectNumber& number : m_uniforms.numbers)
            add_value(number);
        for (const EffectStruct& of : m_uniforms.structs) {
            std::string members;
            for (const EffectNumber& member : of.members) {
                add_constant(member);
                members += (members.empty() ? "" : ", ") + value_of(member);
            }
            m_rules.values[of.name] = "";  // no value where it is declared
            m_structs.push_back({of.name, of.type, members});
        }
    }

    const ShadertoyConstant* constant_of(const EffectNumber& number) const {
        const auto* parameter = std::get_if<const Parameter*>(&number.setter);
        const auto found =
            parameter ? m_shared.constants.find((*parameter)->name) : m_shared.constants.end();
        return found == m_shared.constants.end() ? nullptr : &found->second;
    }

    // Declares the constant of a parameter, once.
    void add_constant(const EffectNumber& number) {
        const ShadertoyConstant* const constant = constant_of(number);
        const bool is_new = constant &&
                            !m_shared.in_common.contains(constant->control.parameter->name) &&
                            m_declared.insert(constant->control.parameter->name).second;
        if (is_new)
            m_head += constant->text;
    }

    // The author's declaration has an annotation that is valid for the constant.
    bool keeps_place(const EffectNumber& number, const ShadertoyConstant& constant) const {
        const bool has_its_name = constant.control.id == number.name;
        if (!constant.is_plain || !has_its_name || has_own_vertex(m_pass) ||
            m_shared.in_common.contains(constant.control.parameter->name))
            return false;
        int count = 0;
        for (const InterfaceStatement& statement : find_interface_statements(m_joined))
            for (const Declarator& one : statement.declarators)
                count += one.name == number.name ? (statement.declarators.size() > 1 ? 2 : 1) : 0;
        for (const Declaration& declaration : find_declarations(m_joined))
            if (declaration.name == number.name && count == 1)
                return std::ranges::any_of(declaration.comments, [&](const Comment& comment) {
                    const bool is_boolean = number.type.scalar == Scalar::boolean;
                    return comment.text.find("@range") != std::string::npos ||
                           comment.text.find("@items") != std::string::npos ||
                           (is_boolean && comment.text.find("@label") != std::string::npos);
                });
        return false;
    }

    void add_value(const EffectNumber& number) {
        const std::string type = glsl_name(number.type);
        if (const auto* fixed = std::get_if<Value>(&number.setter))
            return declare(number.name, {type, glsl_value(number.type, *fixed)});
        if (const ShadertoyConstant* const constant = constant_of(number)) {
            const Value& value = constant->control.value;
            if (keeps_place(number, *constant)) {
                m_rules.constants[number.name] = {type, glsl_value(number.type, value)};
                return;
            }
            add_constant(number);
            m_rules.declared.insert(number.name);
            m_rules.words[number.name] = constant->control.id;
            return;
        }
        if (std::holds_alternative<std::monostate>(number.setter) && is_in_common(number.name)) {
            m_rules.declared.insert(number.name);  // not read here
            return;
        }
        const std::string value = value_of(number);
        const bool is_given = value == number.name || value == "vec3(" + number.name + ".xy, 1.0)";
        if (is_given && is_site_word(number.name)) {
            m_rules.declared.insert(number.name);  // the site's own
            m_rules.words.erase(number.name);
            return;
        }
        declare(number.name, {type, {}});
        m_settings += fmt::format("    {} = {};\n", named(number.name), value);
    }

    // A constant, or a variable without a value. Both stages of a pass share it.
    void declare(const std::string& name, const EffectConstant& of) {
        if (has_own_vertex(m_pass)) {
            m_rules.declared.insert(name);
            m_head += fmt::format("{}{} {}{};\n", of.value.empty() ? "" : "const ", of.type,
                                  named(name), of.value.empty() ? "" : " = " + of.value);
        } else if (of.value.empty()) {
            m_rules.values[name] = "";
        } else {
            m_rules.constants[name] = of;
        }
    }

    bool is_in_common(const std::string& constant) const {
        return std::ranges::any_of(m_shared.in_common, [&](const std::string& parameter) {
            return m_shared.constants.at(parameter).control.id == constant;
        });
    }

    static bool is_site_word(const std::string& name) {
        return std::ranges::find(site_words, name) != site_words.end();
    }

    std::string value_of(const EffectNumber& number) {
        if (const auto* fixed = std::get_if<Value>(&number.setter))
            return glsl_value(number.type, *fixed);
        if (const ShadertoyConstant* const constant = constant_of(number))
            return fmt::format("{}({})", glsl_name(number.type), constant->control.id);
        if (const auto* built = std::get_if<BuiltInUniform>(&number.setter)) {
            ShadertoyValues values(m_pass, m_is_last, m_images);
            return built_in_value(*built, number.type, m_pass, values);
        }
        return glsl_zero(number.type);
    }

    void add_images() {
        for (const Input& input : m_uniforms.samplers)
            declare(input.uniform, {"int", std::to_string(m_images.number_of(input))});
        for (const std::string& uniform : m_uniforms.unread)
            declare(uniform, {"int", "-1"});
    }

    std::string vertex_text() {
        if (!has_own_vertex(m_pass))
            return {};
        VertexFunction vertex = vertex_function(m_pass, m_pass.fragment.text, m_rules);
        m_set_inputs = vertex.name;
        m_vertex_prefix = vertex.prefix;
        return std::move(vertex.text);
    }

    // Each stage may declare a struct, or a variable of the program.
    void set_structs() {
        const auto declares = [](std::string_view text, const std::string& name) {
            const std::vector<std::string> names = global_names(text);
            return std::ranges::find(names, name) != names.end();
        };
        for (const StructValue& of : m_structs) {
            if (declares(m_pass.fragment.text, of.name))
                m_settings +=
                    fmt::format("    {} = {}({});\n", named(of.name), named(of.type), of.members);
            if (!m_vertex_prefix.empty() && declares(m_pass.vertex.text, of.name))
                m_settings += fmt::format("    {0}{1} = {0}{2}({3});\n", m_vertex_prefix, of.name,
                                          of.type, of.members);
        }
    }

    std::string entry_text() {
        std::string input;
        std::string result;
        for (const InterfaceStatement& statement : find_interface_statements(m_joined)) {
            if (statement.declarators.empty())
                continue;
            const std::string name = named(statement.declarators.front().name);
            if (statement.kind == InterfaceStatement::Kind::output)
                result = name;
            if (statement.kind == InterfaceStatement::Kind::input)
                input = name;
        }
        const std::string size = m_is_last ? "iResolution.xy" : m_images.size_of(m_pass.name);
        const std::string place = fmt::format("shadertoy_place / {}", size);
        std::string text =
            "\nvoid mainImage(out vec4 shadertoy_color, in vec2 shadertoy_place) {\n";
        if (size != "iResolution.xy")
            text += fmt::format(
                "    if (any(greaterThan(shadertoy_place, {} + 2.0))) {{\n"
                "        shadertoy_color = vec4(0.0);\n        return;\n    }}\n",
                size);
        text += m_settings;
        if (!m_set_inputs.empty())
            text += fmt::format("    {}({});\n", m_set_inputs, place);
        else if (!input.empty())
            text += fmt::format("    {} = {};\n", input, place);
        text += fmt::format("    {}();\n", named("main"));
        const std::string kept = m_is_last ? std::string() : stored_value(m_pass.format);
        text += fmt::format("    shadertoy_color = {};\n",
                            kept.empty() ? result : "stored(" + result + ")");
        text += "}\n";
        if (!kept.empty())
            text = fmt::format(
                       "\n// What the pass's format stores.\n"
                       "vec4 stored(vec4 color) {{ return {}; }}\n",
                       kept) +
                   text;
        return text;
    }

    struct StructValue {
        std::string name;
        std::string type;
        std::string members;  // arguments of its constructor
    };

    const Pass& m_pass;
    bool m_is_last;
    const EffectUniforms& m_uniforms;
    const ShadertoyShared& m_shared;
    ShadertoyImages& m_images;
    std::string m_joined;  // the fragment shader with its includes
    EffectTextRules m_rules;
    std::set<std::string> m_declared;  // parameters whose constants are in m_head
    std::string m_head;                // constants
    std::string m_settings;            // statements that set variables
    std::vector<StructValue> m_structs;
    std::string m_vertex_prefix;  // "": no vertex shader of its own
    std::string m_set_inputs;     // the function of the vertex shader
};
}  // namespace

std::set<std::string, std::less<>> shadertoy_reserved_names() {
    std::set<std::string, std::less<>> names;
    for (const std::string_view word : site_words)
        names.emplace(word);
    for (const std::string_view word : function_words)
        names.emplace(word);
    return names;
}

Result<std::string> shadertoy_code(std::size_t pass, const EffectUniforms& uniforms,
                                   const ShadertoyShared& shared, ShadertoyImages& images) {
    return CodeWriter(pass, uniforms, shared, images).write();
}
