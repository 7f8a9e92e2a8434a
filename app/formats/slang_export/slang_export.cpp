#include "formats/slang_export/slang_export.h"

#include "formats/effect/effect_files.h"
#include "formats/effect/vertex_function.h"
#include "formats/slang/texel_formats.h"
#include "formats/slang_export/slang_preset_text.h"
#include "formats/slang_export/slang_values.h"
#include "glsl/text/interface_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace fs = std::filesystem;

namespace {
constexpr const char* vertex_stage = R"(
#pragma stage vertex
layout(location = 0) in vec4 Position;
layout(location = 1) in vec2 TexCoord;
layout(location = 0) out vec2 vTexCoord;
void main() {
    gl_Position = global.MVP * Position;
    vTexCoord = TexCoord;
}

#pragma stage fragment
)";

// Slang has no `#pragma once`.
std::string with_guard(const EffectFile& file, const std::string& text) {
    if (!file.is_once)
        return text;
    std::string name = identifier_from(file.name);
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return fmt::format("#ifndef {0}_ONCE\n#define {0}_ONCE\n{1}\n#endif\n", name, text);
}

// The name of a texture in a shader.
std::string texture_name(const Input& input, std::size_t pass) {
    if (input.from == Input::From::source)
        return pass == 0 ? "Source" : "Original";
    return input.frames_ago > 0 ? input.name + "Feedback" : input.name;
}

/// Writes the files of one look.
class SlangWriter {
public:
    SlangWriter(const EffectRequest& request, Effect effect)
        : m_request(request), m_effect(std::move(effect)), m_folder(request.name + "_shaders") {
        m_output.losses = m_effect.losses;
    }

    Result<EffectOutput> write() {
        if (auto read = read_uniforms(); !read)
            return fail(read.error());
        add_controls();
        for (std::size_t i = 0; i < look().passes.size(); ++i)
            if (auto written = write_shader(i); !written)
                return fail(written.error());
        if (auto added = add_pictures(); !added)
            return fail(added.error());
        m_output.texts[m_request.name + ".slangp"] =
            notice_comment(m_request.look, m_request.notices, "#") + include_lines() +
            slang_preset_text(look(), m_shaders, m_pictures);
        return std::move(m_output);
    }

private:
    const Look& look() const { return m_effect.look; }

    std::string notice_lines() const { return notice_comment(m_request.look, m_request.notices); }

    // So that the preset names all files of its folder.
    std::string include_lines() const {
        std::string text;
        for (const auto& [path, content] : m_output.texts)
            if (std::ranges::find(m_shaders, path) == m_shaders.end())
                text += fmt::format("# Included: {}\n", path);
        return text;
    }

    Result<void> read_uniforms() {
        for (std::size_t i = 0; i < look().passes.size(); ++i) {
            auto uniforms = effect_uniforms(look(), i, m_request.values, m_effect.fixed);
            if (!uniforms)
                return fail(uniforms.error());
            for (const EffectNumber& number : uniforms->numbers)
                m_declared.insert(number.name);
            for (const Input& sampler : uniforms->samplers)
                m_declared.insert(sampler.uniform);
            m_declared.insert(uniforms->unread.begin(), uniforms->unread.end());
            m_has_black = m_has_black || !uniforms->unread.empty();
            m_uniforms.push_back(std::move(*uniforms));
        }
        return {};
    }

    void add_controls() {
        auto taken = slang_reserved_names();
        for (const Pass& pass : look().passes)
            taken.insert({pass.name, pass.name + "Size", pass.name + "Feedback"});
        EffectNames names(std::move(taken));
        m_controls = effect_controls(look(), m_request.values, m_effect.fixed, names);
        for (const EffectControl& control : m_controls) {
            std::vector<std::string>& parts = m_parts[control.parameter->name];
            const bool is_one = control.value.numbers.size() == 1;
            for (std::size_t i = 0; i < control.value.numbers.size(); ++i)
                parts.push_back(
                    is_one ? control.id
                           : names.add(fmt::format("{}_{}", control.id,
                                                   component_label(*control.parameter, i))));
        }
    }

    // Only those that the shader reads.
    std::string parameter_lines(const SlangBlock& block) const {
        std::string text;
        for (const EffectControl& control : m_controls) {
            if (!block.used_parameters().contains(control.parameter->name))
                continue;
            const std::vector<std::string>& parts = m_parts.at(control.parameter->name);
            for (std::size_t i = 0; i < parts.size(); ++i)
                text += slang_parameter_line(control, i, parts[i]);
        }
        return text;
    }

    Result<void> write_shader(std::size_t index) {
        const Pass& pass = look().passes[index];
        auto files = effect_files(m_request.look, pass);
        if (!files)
            return fail(files.error());
        SlangBlock block(pass, m_parts);
        const std::string joined = joined_text(*files);
        EffectTextRules rules{.declared = m_declared, .words = renamed_built_ins(joined)};
        const std::string values = value_lines(m_uniforms[index], block, rules.words, index);
        for (const EffectStruct& of : m_uniforms[index].structs)
            rules.values[of.name] = block.value(of);
        const bool has_vertex = has_own_vertex(pass);
        if (has_vertex) {
            rules.words["main"] = "afterglow_main";
        } else {
            rules.input = "layout(location = 0) in";
            rules.output = "layout(location = 0) out";
        }
        std::string text = "#version 450\n";
        for (const std::string& line : extension_lines(joined))
            if (line.find("arrays_of_arrays") == std::string::npos)  // part of GLSL 4.50
                text += line + "\n";
        std::string body = effect_text(files->front().text, rules);
        text += notice_lines() + "\n" + block.declaration() + "\n" + parameter_lines(block);
        text += fmt::format("#pragma name {}\n#pragma format {}\n{}", pass.name,
                            slang_format_name(pass.format), vertex_stage);
        text += values + body;
        if (has_vertex)
            text += own_vertex(pass, rules);
        const fs::path folder = fs::path(files->front().name).parent_path();
        m_shaders.push_back((m_folder / folder / (pass.name + ".slang")).generic_string());
        m_output.texts[m_shaders.back()] = std::move(text);
        return add_includes(*files, rules);
    }

    // The fragment shader's inputs and outputs are variables then.
    static std::string own_vertex(const Pass& pass, const EffectTextRules& rules) {
        std::string output;
        for (const InterfaceStatement& statement :
             find_interface_statements(std::string_view(pass.fragment.text)))
            if (statement.kind == InterfaceStatement::Kind::output &&
                !statement.declarators.empty())
                output = statement.declarators.front().name;
        if (const auto word = rules.words.find(output); word != rules.words.end())
            output = word->second;
        const VertexFunction vertex = vertex_function(pass, pass.fragment.text, rules);
        return vertex.text + fmt::format(
                                 "\nlayout(location = 0) in vec2 afterglow_place;\n"
                                 "layout(location = 0) out vec4 afterglow_color;\n"
                                 "void main() {{\n    {}(afterglow_place);\n    afterglow_main();\n"
                                 "    afterglow_color = {};\n}}\n",
                                 vertex.name, output);
    }

    // The samplers, and the values of the other uniforms.
    std::string value_lines(const EffectUniforms& uniforms, SlangBlock& block,
                            const WordChanges& words, std::size_t index) const {
        std::string text;
        std::vector<std::string> declared;
        const auto named = [&](const std::string& name) {
            const auto word = words.find(name);
            return word == words.end() ? name : word->second;
        };
        const auto add_sampler = [&](const std::string& uniform, const std::string& texture) {
            if (std::ranges::find(declared, texture) == declared.end()) {
                constexpr std::size_t first_binding = 2;
                text += fmt::format("layout(set = 0, binding = {}) uniform sampler2D {};\n",
                                    first_binding + declared.size(), texture);
                declared.push_back(texture);
            }
            if (named(uniform) != texture)
                text += fmt::format("#define {} {}\n", named(uniform), texture);
        };
        for (const Input& input : uniforms.samplers)
            add_sampler(input.uniform, texture_name(input, index));
        for (const std::string& uniform : uniforms.unread)
            add_sampler(uniform, slang_black);
        for (const EffectNumber& number : uniforms.numbers)
            text += fmt::format("{} {} = {};\n", glsl_name(number.type), named(number.name),
                                block.value(number));
        return text;
    }

    Result<void> add_includes(const std::vector<EffectFile>& files, const EffectTextRules& rules) {
        for (std::size_t i = 1; i < files.size(); ++i) {
            const std::string path = (m_folder / fs::path(files[i].name)).generic_string();
            std::string text = with_guard(files[i], effect_text(files[i].text, rules));
            const auto [known, is_new] = m_output.texts.try_emplace(path, text);
            if (!is_new && known->second != text)
                return fail({{},
                             0,
                             fmt::format("'{}' is included by passes with and without a vertex "
                                         "shader, which the export can't write. Copy the file.",
                                         files[i].name)});
        }
        return {};
    }

    Result<void> add_pictures() {
        auto pictures = effect_pictures(look(), m_folder.generic_string(), RowOrder::top_first,
                                        m_has_black ? slang_black : "");
        if (!pictures)
            return fail(pictures.error());
        m_pictures = std::move(*pictures);
        for (const EffectPicture& picture : m_pictures)
            m_output.pictures[picture.path] = picture.file;
        return {};
    }

    const EffectRequest& m_request;
    Effect m_effect;
    fs::path m_folder;
    std::vector<EffectUniforms> m_uniforms;  // of each pass
    std::set<std::string, std::less<>> m_declared;
    std::vector<EffectControl> m_controls;
    std::map<std::string, std::vector<std::string>> m_parts;  // names of components by parameter
    std::vector<std::string> m_shaders;                       // paths
    std::vector<EffectPicture> m_pictures;
    bool m_has_black = false;
    EffectOutput m_output;
};
}  // namespace

const EffectHost& slang_host() {
    static const EffectHost host{
        .name = "RetroArch", .samples_per_texture = true, .has_date = false};
    return host;
}

Result<EffectOutput> slang_files(const EffectRequest& request) {
    auto effect =
        effect_of(request.look, request.values, request.size, request.source, slang_host());
    if (!effect)
        return fail(effect.error());
    return SlangWriter(request, std::move(*effect)).write();
}
