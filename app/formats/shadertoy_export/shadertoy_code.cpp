#include "formats/shadertoy_export/shadertoy_code.h"

#include "base/text.h"
#include "formats/effect/built_in_value.h"
#include "formats/effect/effect_files.h"
#include "formats/effect/effect_text.h"
#include "formats/effect/global_values.h"
#include "formats/effect/struct_values.h"
#include "formats/effect/vertex_function.h"
#include "formats/shadertoy_export/shadertoy_words.h"
#include "glsl/text/declarations.h"
#include "glsl/text/interface_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace {
constexpr auto site_sampling =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"texture", "image_at"},
                                                                  {"textureLod", "image_lod"},
                                                                  {"texelFetch", "image_fetch"},
                                                                  {"textureSize", "image_size"},
                                                                  {"textureGather", "image_gather"},
                                                                  {"sampler2D", "int"}});

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
    std::string press() override { return "iMouse"; }

private:
    const Pass& m_pass;
    bool m_is_last;
    ShadertoyImages& m_images;
};

/// Writes the code of one pass, or of a pass that another one draws where it reads it.
class CodeWriter {
public:
    // `prefix`: of all names of a pass in another one; "": the pass has a buffer of its own.
    CodeWriter(std::size_t pass, const ShadertoyShared& shared, ShadertoyImages& images,
               std::string prefix = {})
        : m_pass(shared.plan.look.passes[pass]),
          m_is_last(pass + 1 == shared.plan.look.passes.size()),
          m_uniforms(shared.uniforms[pass]),
          m_shared(shared),
          m_images(images),
          m_prefix(std::move(prefix)) {}

    Result<std::string> write() {
        if (auto read = read_text(); !read)
            return fail(read.error());
        std::string inlined;
        for (const std::string& name : m_images.inlined()) {
            CodeWriter other(static_cast<std::size_t>(*find_pass(m_shared.plan.look, name)),
                             m_shared, m_images, "drawn_" + name + "_");
            auto text = other.write_inlined();
            if (!text)
                return text;
            inlined += *text;
            m_head += other.m_head;
            m_entry.settings += other.m_entry.settings;
        }
        prepare();
        const std::string body = body_text();
        const std::string vertex = vertex_text();
        set_structs();
        const std::string entry = entry_text();
        return m_images.readers() + functions() + (m_head.empty() ? "" : "\n" + m_head) + inlined +
               "\n" + body + vertex + entry;
    }

    // The points of the beam.
    Result<std::string> write_table() {
        const auto passed = shadertoy_passed_values(m_pass);
        if (!passed)
            return fail(passed.error());
        m_joined = *m_pass.vertex.text;
        prepare();
        m_rules.words["gl_Position"] = "point_clip";
        m_rules.words["gl_PointSize"] = "point_size";
        m_rules.words["gl_VertexID"] = "point_number";
        m_head += "vec4 point_clip;\nfloat point_size;\nint point_number;\n";
        std::vector<ShadertoyPassedValue> outputs = *passed;
        for (ShadertoyPassedValue& value : outputs)
            value.name = named(value.name);
        std::string inputs = "    point_number = k;\n    point_size = 1.0;\n";
        for (const InterfaceStatement& statement : find_interface_statements(m_joined))
            for (const Declarator& one : statement.declarators)
                if (statement.kind == InterfaceStatement::Kind::input)
                    inputs += fmt::format("    {} = {};\n", named(one.name),
                                          one.name == "position"      ? "point.xy"
                                          : one.name == "intensity"   ? "point_light"
                                          : one.name == "age_seconds" ? "point_age"
                                                                      : statement.type + "(1.0)");
        return m_head + "\n" + m_shared.beam->signal + "\n" +
               std::string(trim(effect_text(m_joined, m_rules))) + "\n" +
               shadertoy_table_entry(*m_shared.beam, outputs, m_entry.settings, inputs);
    }

private:
    Result<void> read_text() {
        auto files = effect_files(m_shared.author, m_pass);
        if (!files)
            return fail(files.error());
        m_joined = joined_text(*files);
        add_words(m_joined, m_words);
        if (has_own_vertex(m_pass) && m_prefix.empty())
            add_words(m_pass.vertex.text, m_words);
        const auto refuse = [&](const std::string& what) {
            return fail(
                {{},
                 0,
                 fmt::format("the pass '{}' {}. Export it with --to web.", m_pass.name, what)});
        };
        if (const std::string word = unusable_word(m_words); !word.empty())
            return refuse(fmt::format("uses {}(), which Shadertoy's passes can't do here", word));
        const bool is_wrapped = std::ranges::any_of(
            m_pass.inputs, [](const Input& input) { return input.sampler.wrap != Wrap::edge; });
        if (m_words.contains("textureGather") && is_wrapped)
            return refuse("uses textureGather() beyond the edges of a picture");
        if (m_pass.format == Format::srgb8_alpha8 || m_pass.format == Format::rgb10_a2)
            return refuse(fmt::format("rounds its texels to {}, which Shadertoy's buffers don't do",
                                      info_of(m_pass.format).name));
        return {};
    }

    // That read the pictures of this pass.
    std::string functions() {
        return replace_all(m_images.functions(m_pass, m_words, calls_with_bias(m_joined)), "image_",
                           m_prefix + "image_");
    }

    void prepare() {
        change_words();
        add_values();
        add_images();
    }

    // As functions of the pass that reads it: vec4 drawn_NAME(ivec2 at).
    Result<std::string> write_inlined() {
        if (auto read = read_text(); !read)
            return fail(read.error());
        prepare();
        m_head += fmt::format("vec4 {0}fragcoord;\nvec2 {0}pointcoord;\n", m_prefix);
        const std::string text =
            fmt::format("\n// Pass {}.\n", m_pass.name) + functions() + "\n" + body_text();
        set_structs();
        const ShaderEnds ends = ends_of_shader(m_joined, m_rules.words);
        if (m_pass.name == m_shared.plan.beam) {
            m_entry.settings += m_entry.globals;
            const auto passed = shadertoy_passed_values(m_pass);
            if (!passed)
                return fail(passed.error());
            return text + shadertoy_beam_sum(*m_shared.beam, *passed, m_prefix, ends.output,
                                             m_images.table_channel());
        }
        const std::string place =
            fmt::format("{}fragcoord.xy / {}", m_prefix, m_images.size_of(m_pass.name));
        return text +
               fmt::format(
                   "\nvec4 drawn_{}(ivec2 at) {{\n"
                   "    {}fragcoord = vec4(vec2(at) + 0.5, 0.5, 1.0);\n{}{}"
                   "    {}();\n    return {};\n}}\n",
                   m_pass.name, m_prefix,
                   ends.input.empty() ? "" : fmt::format("    {} = {};\n", ends.input, place),
                   m_entry.globals, named("main"), ends.output);
    }

    std::string body_text() {
        add_input_names(m_joined, m_rules.words, m_entry.late);
        std::string body = effect_text(m_joined, m_rules);
        m_entry.globals = take_late_values(body, m_entry.late);
        return std::string(trim(body)) + "\n";
    }

    // Names of the site and of our functions.
    void change_words() {
        m_rules.words = renamed_built_ins(m_joined);
        for (const auto& [word, other] : site_sampling)
            m_rules.words[std::string(word)] =
                other.starts_with("image_") ? m_prefix + std::string(other) : std::string(other);
        if (!m_prefix.empty()) {
            for (const std::string& name : global_names(m_joined))
                m_rules.words[name] = m_prefix + name;
            m_rules.words["main"] = m_prefix + "main";
            m_rules.words["gl_FragCoord"] = m_prefix + "fragcoord";
            m_rules.words["gl_PointCoord"] = m_prefix + "pointcoord";
            return;
        }
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

    std::string named(const std::string& name) const { return renamed_word(m_rules.words, name); }

    // A pass in another one has its fragment shader only.
    bool is_declared_here(const std::string& uniform) const {
        return m_prefix.empty() || m_rules.words.contains(uniform);
    }

    void add_values() {
        for (const EffectNumber& number : m_uniforms.numbers)
            if (is_declared_here(number.name))
                add_value(number);
        for (const EffectStruct& of : m_uniforms.structs) {
            std::string members;
            for (const EffectNumber& member : of.members) {
                add_constant(member);
                members += (members.empty() ? "" : ", ") + value_of(member);
            }
            m_rules.values[of.name] = "";  // no value where it is declared
            m_entry.late.insert(named(of.name));
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
        if (!constant.is_plain || !has_its_name || has_shared_names() ||
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
        const bool is_given_here = std::holds_alternative<BuiltInUniform>(number.setter) ||
                                   m_pass.set.contains(number.name);
        if (!is_given_here && is_in_common(number.name)) {
            m_rules.declared.insert(number.name);  // not read here
            m_rules.words.erase(number.name);
            return;
        }
        m_entry.late.insert(named(number.name));
        if (const auto* fixed = std::get_if<Value>(&number.setter))
            return declare_fixed(number, *fixed);
        const std::string value = value_of(number);
        const bool is_given = value == number.name || value == "vec3(" + number.name + ".xy, 1.0)";
        if (is_given && is_shadertoy_word(number.name)) {
            m_rules.declared.insert(number.name);  // the site's own
            m_rules.words.erase(number.name);
            m_entry.late.insert(number.name);
            return;
        }
        declare(number.name, {type, {}});
        m_entry.settings += fmt::format("    {} = {};\n", named(number.name), value);
    }

    // Not a constant: an index that is one must be within its array, also where it is not used.
    void declare_fixed(const EffectNumber& number, const Value& value) {
        const std::string text = glsl_value(number.type, value);
        m_rules.values[number.name] = text;
        if (has_shared_names()) {
            m_rules.declared.insert(number.name);
            m_head +=
                fmt::format("{} {} = {};\n", glsl_name(number.type), named(number.name), text);
        }
    }

    // Both stages of a pass share their variables, and a pass in another one has its own.
    bool has_shared_names() const { return has_own_vertex(m_pass) || !m_prefix.empty(); }

    // A constant, or a variable without a value.
    void declare(const std::string& name, const EffectConstant& of) {
        if (has_shared_names()) {
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
            if (is_declared_here(input.uniform))
                declare(input.uniform, {"int", std::to_string(m_images.number_of(input))});
        for (const std::string& uniform : m_uniforms.unread)
            if (is_declared_here(uniform))
                declare(uniform, {"int", "-1"});
    }

    std::string vertex_text() {
        if (!has_own_vertex(m_pass))
            return {};
        VertexFunction vertex = vertex_function(m_pass, m_pass.fragment.text, m_rules);
        m_entry.settings += take_late_values(vertex.text, m_entry.late);
        m_set_inputs = vertex.name;
        m_vertex_prefix = vertex.prefix;
        return std::move(vertex.text);
    }

    void set_structs() {
        m_entry.settings += struct_settings(m_pass, m_structs, m_rules.words, m_vertex_prefix);
    }

    std::string entry_text() {
        const ShaderEnds ends = ends_of_shader(m_joined, m_rules.words);
        const std::string size = m_is_last ? "iResolution.xy" : m_images.size_of(m_pass.name);
        const std::string place = fmt::format("shadertoy_place / {}", size);
        std::string text =
            "\nvoid mainImage(out vec4 shadertoy_color, in vec2 shadertoy_place) {\n";
        if (size != "iResolution.xy")
            text += fmt::format(
                "    if (any(greaterThan(shadertoy_place, {} + 2.0))) {{\n"
                "        shadertoy_color = vec4(0.0);\n        return;\n    }}\n",
                size);
        text += m_entry.settings;
        if (!m_set_inputs.empty())
            text += fmt::format("    {}({});\n", m_set_inputs, place);
        else if (!ends.input.empty())
            text += fmt::format("    {} = {};\n", ends.input, place);
        text += m_entry.globals + fmt::format("    {}();\n", named("main"));
        const std::string kept = m_is_last ? std::string() : stored_value(m_pass.format);
        text += fmt::format("    shadertoy_color = {};\n",
                            kept.empty() ? ends.output : "stored(" + ends.output + ")");
        text += "}\n";
        if (!kept.empty())
            text = fmt::format(
                       "\n// What the pass's format stores.\n"
                       "vec4 stored(vec4 color) {{ return {}; }}\n",
                       kept) +
                   text;
        return text;
    }

    const Pass& m_pass;
    bool m_is_last;
    const EffectUniforms& m_uniforms;
    const ShadertoyShared& m_shared;
    ShadertoyImages& m_images;
    std::string m_prefix;
    GlslWords m_words;     // of the text
    std::string m_joined;  // the fragment shader with its includes
    EffectTextRules m_rules;
    std::set<std::string> m_declared;  // parameters whose constants are in m_head
    std::string m_head;                // constants
    EntryValues m_entry;
    std::vector<StructValue> m_structs;
    std::string m_vertex_prefix;  // "": no vertex shader of its own
    std::string m_set_inputs;     // the function of the vertex shader
};
}  // namespace

Result<std::string> shadertoy_code(std::size_t pass, const ShadertoyShared& shared,
                                   ShadertoyImages& images) {
    return CodeWriter(pass, shared, images).write();
}

Result<std::string> shadertoy_table_code(std::size_t pass, const ShadertoyShared& shared,
                                         ShadertoyImages& images) {
    return CodeWriter(pass, shared, images).write_table();
}
