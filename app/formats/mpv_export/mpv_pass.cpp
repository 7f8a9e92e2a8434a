#include "formats/mpv_export/mpv_pass.h"

#include "formats/effect/effect_files.h"
#include "formats/effect/effect_text.h"
#include "formats/effect/vertex_function.h"
#include "formats/mpv_export/mpv_functions.h"
#include "formats/mpv_export/mpv_sampling.h"
#include "formats/mpv_export/mpv_values.h"
#include "glsl/text/interface_statements.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
// libplacebo, which draws with --vo=gpu-next, has this macro. It counts blocks instead of frames.
constexpr const char* frame_lines = R"(#ifdef linearize
int afterglow_frame = (frame - 1) / {} + 1;
#else
int afterglow_frame = frame;
#endif
vec2 afterglow_output = target_size;
vec2 afterglow_source = HOOKED_size;
vec2 afterglow_target = {};
vec4 afterglow_coord;
)";

/// Writes the block of one pass.
class PassWriter {
public:
    PassWriter(std::size_t pass, const EffectUniforms& uniforms, const MpvContext& context)
        : m_index(pass),
          m_pass(context.look.passes[pass]),
          m_uniforms(uniforms),
          m_context(context),
          m_values(context.look, pass, context.parameters) {}

    Result<MpvPass> write() {
        auto files = effect_files(m_context.author, m_pass);
        if (!files)
            return fail(files.error());
        const std::string joined = joined_text(*files);
        add_words(joined, m_words);
        if (has_own_vertex(m_pass))
            add_words(std::string_view(m_pass.vertex.text), m_words);
        if (m_words.contains("discard"))
            return fail({{},
                         0,
                         fmt::format("the pass '{}' discards pixels, which mpv can't do. Export it "
                                     "with --to web or --to slang.",
                                     m_pass.name)});
        rename_words(joined);
        add_values();
        const MpvSampling sampling = mpv_sampling(m_uniforms, m_context.textures, m_words);
        for (const auto& [name, other] : sampling.macros)
            define(named(name), other);
        const std::string author = effect_text(joined, m_rules);
        const std::string vertex = vertex_text();
        MpvPass made{.block = block(), .parameters = m_values.used_parameters()};
        made.block.body =
            fmt::format(fmt::runtime(frame_lines), m_context.blocks, mpv_size(m_pass)) + m_copies +
            m_context.parameters.undefines(made.parameters) + m_globals + sampling.declarations +
            m_defines + "\n" + author + "\n" + vertex + "\n" + undefines(joined) +
            stored_functions(sampling.declarations) + hook(joined);
        return made;
    }

private:
    bool is_last() const { return m_index + 1 == m_context.look.passes.size(); }
    // mpv's rows start at the top.
    bool is_turned() const { return is_last() && m_pass.rows == RowOrder::bottom_first; }

    MpvBlock block() const {
        return {.about = m_context.look.name + ": " + m_pass.name,
                .binds = m_context.textures.binds_of(m_pass),
                .save = is_last() ? "" : MpvTextures::name_of(m_pass),
                .width = mpv_side(m_pass.size[0], 0),
                .height = mpv_side(m_pass.size[1], 1),
                .values = {},
                .body = {}};
    }

    void rename_words(const std::string& joined) {
        m_rules.words = renamed_built_ins(joined);
        for (const std::string& word : mpv_reserved_words())
            m_rules.words[word] = "own_" + word;
        m_rules.words["main"] = "afterglow_main";
        m_rules.words["gl_FragCoord"] = "afterglow_coord";
        if (is_turned() && m_words.contains("dFdy")) {
            m_rules.words["dFdy"] = "afterglow_dFdy";
            define("afterglow_dFdy(x)", "(-dFdy(x))");
        }
    }

    std::string named(const std::string& name) const { return renamed_word(m_rules.words, name); }

    void define(const std::string& name, const std::string& text) {
        m_defines += fmt::format("#define {} {}\n", name, text);
        m_macros.push_back(name.substr(0, name.find('(')));
    }

    void add_values() {
        for (const EffectNumber& number : m_uniforms.numbers)
            add_value(number);
        for (const EffectStruct& of : m_uniforms.structs) {
            std::string members;
            for (const EffectNumber& member : of.members)
                members += (members.empty() ? "" : ", ") + copy(member, identifier(member.name));
            m_rules.values[of.name] = members;
        }
        for (const Input& input : m_uniforms.samplers)
            m_rules.declared.insert(input.uniform);
        m_rules.declared.insert(m_uniforms.unread.begin(), m_uniforms.unread.end());
    }

    static std::string identifier(std::string name) {
        std::ranges::replace(name, '.', '_');
        return name;
    }

    // A variable with the value, before a name of the author hides what it consists of.
    std::string copy(const EffectNumber& number, const std::string& name) {
        std::string variable = fmt::format("{}value_{}", mpv_prefix, name);
        m_copies +=
            fmt::format("{} {} = {};\n", glsl_name(number.type), variable, m_values.value(number));
        return variable;
    }

    // A macro replaces a parameter, whose name mpv may have declared.
    void add_value(const EffectNumber& number) {
        m_rules.declared.insert(number.name);
        const std::string name = named(number.name);
        if (const Parameter* const parameter = mpv_parameter(number, m_context.parameters)) {
            const std::string variable = copy(number, number.name);
            if (m_context.parameters.is_macro(*parameter, name)) {
                define(name, variable);
                return;
            }
            m_globals += fmt::format("{} {} = {};\n", glsl_name(number.type), name, variable);
            return;
        }
        m_globals +=
            fmt::format("{} {} = {};\n", glsl_name(number.type), name, m_values.value(number));
    }

    // What hook() calls and the text does not have yet.
    std::string stored_functions(const std::string& declared) const {
        std::vector<MpvFunction> functions = mpv_rounding_functions();
        std::erase_if(functions, [&](const MpvFunction& function) {
            return declared.find("vec4 " + function.name + "(") != declared.npos;
        });
        std::set<std::string> wanted;
        if (!is_last())
            add_mpv_calls(functions, mpv_stored(m_pass.format, ""), wanted);
        return mpv_function_text(functions, wanted);
    }

    std::string vertex_text() {
        if (!has_own_vertex(m_pass))
            return {};
        VertexFunction vertex = vertex_function(m_pass, m_pass.fragment.text, m_rules);
        m_set_inputs = vertex.name;
        return std::move(vertex.text);
    }

    // Macros of the author would change the rest of mpv's shader.
    std::string undefines(const std::string& joined) const {
        std::set<std::string> names(m_macros.begin(), m_macros.end());
        for (const std::string_view text :
             {std::string_view(joined), std::string_view(m_pass.vertex.text)}) {
            const Tokens tokens = scan(text);
            for (const Directive& directive : find_directives(text, tokens))
                if (directive.name == "define" && !directive.arguments.empty())
                    names.insert(named(std::string(directive.arguments.front().text)));
        }
        std::string lines;
        for (const std::string& name : names)
            lines += fmt::format("#undef {}\n", name);
        return lines;
    }

    std::string hook(const std::string& joined) const {
        std::string text = fmt::format(
            "\nvec4 hook() {{\n    vec2 afterglow_place = {};\n"
            "    afterglow_coord = vec4(afterglow_place * afterglow_target, 0.0, 1.0);\n",
            is_turned() ? "vec2(HOOKED_pos.x, 1.0 - HOOKED_pos.y)" : "HOOKED_pos");
        std::string output = "vec4(0.0)";
        for (const InterfaceStatement& statement : find_interface_statements(joined)) {
            if (statement.declarators.empty())
                continue;
            const std::string name = named(statement.declarators.front().name);
            if (statement.kind == InterfaceStatement::Kind::output)
                output = statement.type == "vec3" ? fmt::format("vec4({}, 1.0)", name) : name;
            if (statement.kind == InterfaceStatement::Kind::input && m_set_inputs.empty())
                text += fmt::format("    {} = afterglow_place;\n", name);
        }
        if (!m_set_inputs.empty())
            text += fmt::format("    {}(afterglow_place);\n", m_set_inputs);
        return text + fmt::format("    afterglow_main();\n    return {};\n}}\n",
                                  is_last() ? fmt::format("vec4({}.rgb, 1.0)", output)
                                            : mpv_stored(m_pass.format, output));
    }

    std::size_t m_index;
    const Pass& m_pass;
    const EffectUniforms& m_uniforms;
    const MpvContext& m_context;
    MpvValues m_values;
    GlslWords m_words;
    EffectTextRules m_rules;
    std::string m_copies;   // values of parameters and structs
    std::string m_globals;  // other uniforms
    std::string m_defines;
    std::vector<std::string> m_macros;
    std::string m_set_inputs;  // the function of the vertex shader; "": it has none
};
}  // namespace

Result<MpvPass> mpv_pass(std::size_t pass, const EffectUniforms& uniforms,
                         const MpvContext& context) {
    return PassWriter(pass, uniforms, context).write();
}
