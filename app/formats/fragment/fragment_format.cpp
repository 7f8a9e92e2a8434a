#include "formats/fragment/fragment_format.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/fragment/fragment_names.h"
#include "formats/fragment/fragment_stage.h"
#include "formats/fragment/host_names.h"
#include "formats/fragment/varyings.h"
#include "glsl/cache/check_cache.h"
#include "glsl/parameters/constant_parameters.h"
#include "glsl/parameters/parameters.h"
#include "glsl/text/include.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t max_varyings = 256;
constexpr int frames_shown = 120;  // two seconds: many shaders start black
constexpr const char* source_pattern = "pattern:harbour";

constexpr std::array fragment_endings{".frag", ".fsh", ".fs", ".glsl"};

bool defines_main(std::string_view text) {
    std::string_view before;
    for (const Token& token : scan(text).all) {
        if (token.kind == Token::Kind::comment)
            continue;
        if (before == "void" && token.is("main"))
            return true;
        before = token.text;
    }
    return false;
}

/// Converts a text to a look, one pass at a time.
class FragmentLook {
public:
    FragmentLook(const Stage& written, const LoadOptions& help, Diagnostics& warnings)
        : m_written(written), m_help(help), m_warnings(warnings) {}

    Result<Look> make() {
        GlslWords words;
        add_words(m_written.text, words);
        const std::vector<FragmentPass> passes = fragment_passes(words);
        for (const FragmentPass& pass : passes)
            add_pass(pass, passes.size() == 1);
        if (auto problems = write_constants(m_look, m_help.values, m_help.cache); !problems.empty())
            return fail(std::move(problems));
        for (std::size_t i = 0; i < m_look.passes.size(); ++i)
            if (auto problems = feed(i); !problems.empty())
                return fail(std::move(problems));
        auto parameters = find_parameters(m_look, m_help.cache, m_warnings);
        if (!parameters)
            return fail(std::move(parameters.error()));
        m_look.parameters.insert(m_look.parameters.begin(), parameters->begin(), parameters->end());
        for (Parameter& parameter : m_look.parameters)
            if (parameter.control == Control::image && parameter.initial.path.empty())
                parameter.initial = Value::of_path(default_picture(parameter.name));
        m_look.source_encoding = Encoding::display;
        m_look.output = Encoding::display;
        m_look.settle_frames = frames_shown;
        return std::move(m_look);
    }

private:
    void add_pass(const FragmentPass& asked, bool is_alone) {
        Pass pass;
        pass.name = asked.name;
        pass.built_ins.clear();
        pass.declared = {m_written.file, 1};
        pass.format = is_alone || asked.define.empty() ? Format::rgba8 : Format::rgba32f;
        pass.output = Encoding::display;
        pass.fragment = fragment_shader_stage(m_written, asked.define);
        GlslWords words;
        add_words(pass.fragment.text, words);
        for (const BuiltInUniform& built_in : fragment_built_ins())
            if (words.contains(built_in.name))
                pass.built_ins.push_back(built_in);
        m_look.passes.push_back(std::move(pass));
    }

    Diagnostics feed(std::size_t index) {
        Pass& pass = m_look.passes[index];
        const std::vector<FragmentVarying> varyings = find_varyings(pass.fragment.text);
        if (varyings.size() > max_varyings) {
            const Location at = location_in(pass.fragment, varyings[max_varyings].line);
            return {{at.file, at.line,
                     fmt::format("the shader has {} varyings; the limit is {}", varyings.size(),
                                 max_varyings)}};
        }
        pass.vertex = vertex_stage_for(varyings, pass.fragment, m_warnings);
        const auto checked = m_help.cache ? m_help.cache->check(pass.vertex, pass.fragment)
                                          : check_program(pass.vertex, pass.fragment);
        if (!checked)
            return checked.error();
        for (const Uniform& uniform : checked->uniforms) {
            if (uniform.kind == Uniform::Kind::sampler)
                feed_sampler(uniform, index);
            else
                tell_size(uniform.name, pass);
        }
        return {};
    }

    void feed_sampler(const Uniform& uniform, std::size_t index) {
        Pass& pass = m_look.passes[index];
        const auto drawn = find_pass(m_look, uniform.name);
        const auto last = static_cast<int>(m_look.passes.size()) - 1;
        if (drawn && *drawn < last) {
            const bool is_of_last_frame = static_cast<std::size_t>(*drawn) >= index;
            pass.inputs.push_back(
                {uniform.name, Input::From::pass, uniform.name, is_of_last_frame ? 1 : 0, {}});
        } else if (is_fragment_source(uniform.name)) {
            m_look.driven_by = Driver::picture;
            m_look.default_source = source_pattern;
            pass.inputs.push_back({uniform.name, Input::From::source, {}, 0, {}});
        } else if (uniform.type_name == "samplerCube" || uniform.type_name == "sampler3D") {
            feed_solid(uniform, index);
        } else if (is_drawn_by_viewer(uniform.name)) {
            const Location& at = uniform.declared.front();
            add_new(m_warnings, {at.file, at.line,
                                 fmt::format("'{}' is a scene or buffer of glslViewer, which isn't "
                                             "available here. Choose a picture for it.",
                                             uniform.name),
                                 Severity::warning});
        }
    }

    // A cube or volume input. The user chooses a flat picture for it.
    void feed_solid(const Uniform& uniform, std::size_t index) {
        const bool is_cube = uniform.type_name == "samplerCube";
        m_look.passes[index].inputs.push_back(
            {uniform.name, Input::From::image, uniform.name, 0, {}});
        auto known = std::ranges::find(m_look.parameters, uniform.name, &Parameter::name);
        if (known == m_look.parameters.end()) {
            Parameter chosen;
            chosen.name = uniform.name;
            chosen.label = uniform.name;
            chosen.control = Control::image;
            chosen.declared = uniform.declared.front();
            chosen.initial = Value::of_path(is_cube ? "solid:sky" : "solid:noise-volume");
            Image image;
            image.name = uniform.name;
            image.rows = RowOrder::top_first;
            image.shape = is_cube ? PictureShape::cube : PictureShape::volume;
            m_look.images.push_back(std::move(image));
            known = m_look.parameters.insert(m_look.parameters.end(), std::move(chosen));
        }
        known->bindings.push_back({static_cast<int>(index), uniform.name});
    }

    // Adds the size `u_tex0Resolution` of `u_tex0`.
    static void tell_size(const std::string& name, Pass& pass) {
        constexpr std::string_view asks_size = "Resolution";
        if (!name.starts_with("u_tex") || !name.ends_with(asks_size))
            return;
        const std::string sampler = name.substr(0, name.size() - asks_size.size());
        pass.built_ins.push_back(
            {name, BuiltIn::input_resolution, Input{sampler, Input::From::image, sampler, 0, {}}});
    }

    const Stage& m_written;
    const LoadOptions& m_help;
    Diagnostics& m_warnings;
    Look m_look;
};

Result<Look> read_fragment_look(const fs::path& file, const IncludeFolders& includes,
                                const LoadOptions& help, LoadedLook& loaded) {
    const auto written =
        load_stage(file, {file.parent_path(), includes, host_chunks()}, loaded.files, help.disk);
    if (!written)
        return fail(written.error());
    loaded.is_parsed = true;
    auto look = FragmentLook(*written, help, loaded.warnings).make();
    if (!look)
        return look;
    look->id = foreign_look_id(file);
    look->name = file.stem().string();
    look->manifest = file;
    return look;
}
}  // namespace

bool is_fragment_file(const fs::path& file) {
    constexpr std::size_t max_text = std::size_t{4} << 20;
    if (std::ranges::find(fragment_endings, to_lower(file.extension().string())) ==
        fragment_endings.end())
        return false;
    std::error_code error;
    const auto text = read_start(file, max_text);
    return text ? defines_main(*text) : !fs::exists(file, error);
}

LoadedLook load_fragment_look(const fs::path& file, const IncludeFolders& includes,
                              const LoadOptions& help) {
    LoadedLook loaded;
    loaded.look = read_fragment_look(file, includes, help, loaded);
    return loaded;
}
