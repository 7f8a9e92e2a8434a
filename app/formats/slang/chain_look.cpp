#include "formats/slang/chain_look.h"

#include "formats/slang/controls.h"
#include "formats/slang/names.h"
#include "formats/slang/sampling.h"
#include "formats/slang/similar_file.h"
#include "formats/slang/texel_formats.h"
#include "glsl/compile/check.h"
#include "glsl/text/include.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace fs = std::filesystem;

namespace {
using Of = SlangPicture::Of;

// With the corners of all passes: between two texels the last bit of a coordinate matters.
constexpr const char* stretching_corners = R"(#version 410 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 corner;
out vec2 at;
void main() {
    gl_Position = vec4(2.0 * position.x - 1.0, 1.0 - 2.0 * position.y, 0.0, 1.0);
    at = corner;
}
)";
constexpr const char* stretching = R"(#version 410 core
in vec2 at;
uniform sampler2D image;
out vec4 color;
void main() { color = texture(image, at); }
)";

// Named by alias, otherwise by file.
std::vector<std::string> pass_names_of(const TranslatedChain& chain,
                                       const std::vector<std::string>& aliases) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < aliases.size(); ++i) {
        const std::string wanted =
            !aliases[i].empty() ? aliases[i] : chain.preset.passes[i].shader.stem().string();
        std::string name = wanted.empty() ? "pass" : wanted;
        for (int copy = 2; std::ranges::find(names, name) != names.end(); ++copy)
            name = fmt::format("{}-{}", wanted, copy);
        names.push_back(std::move(name));
    }
    return names;
}

std::vector<std::string> aliases_of(const TranslatedChain& chain) {
    std::vector<std::string> aliases;
    for (std::size_t i = 0; i < chain.shaders.size(); ++i)
        aliases.push_back(chain.preset.passes[i].alias.empty() ? chain.shaders[i].alias
                                                               : chain.preset.passes[i].alias);
    return aliases;
}

std::vector<std::string> texture_names_of(const SlangPreset& preset) {
    std::vector<std::string> names;
    for (const SlangTexture& texture : preset.textures)
        names.push_back(texture.name);
    return names;
}

bool is_missing(const SlangTexture& texture) {
    std::error_code error;
    return !fs::is_regular_file(texture.file, error);
}

Side side_of(const SlangScale& scale) {
    constexpr double minimum = 1e-6;  // px or factor; smaller sizes are one texel
    switch (scale.by) {
        case SlangScale::By::viewport:
            return {Side::By::viewport, std::max(scale.factor, minimum), {}};
        case SlangScale::By::absolute:
            return {Side::By::pixels, std::max(scale.factor, 1.0), {}};
        case SlangScale::By::original:
            return {Side::By::source, std::max(scale.factor, minimum), {}};
        case SlangScale::By::source:
            break;
    }
    return {Side::By::before, std::max(scale.factor, minimum), {}};
}

/// Converts a chain to a look, one pass at a time.
class ChainLook {
public:
    ChainLook(const TranslatedChain& chain, const SlangDefaults& defaults, Diagnostics& warnings)
        : m_chain(chain),
          m_aliases(aliases_of(chain)),
          m_names(m_aliases, texture_names_of(chain.preset)),
          m_sampling(chain.preset, defaults.filter),
          m_defaults(defaults),
          m_pass_names(pass_names_of(chain, m_aliases)),
          m_warnings(warnings) {}

    Result<Look> make();

private:
    void check_aliases();
    void make_pass(std::size_t index);
    Format format_of(std::size_t index);
    bool is_stretched() const;
    void check_image(const Pass& pass, const NamedSampler& sampler, int texture);
    void read_samplers(Pass& pass, std::size_t index);
    void read_members(Pass& pass, std::size_t index);
    void tell(Pass& pass, const BlockMember& member, const SlangMember& meant);
    std::optional<Input> input_of(const SlangPicture& picture, std::size_t reader);
    bool has_type(const BlockMember& member, const NumberType& type, const Pass& pass);
    void add_images();
    void add_stretch();
    void add_parameters();
    void problem(const Pass& pass, Severity severity, std::string message);

    const TranslatedChain& m_chain;
    std::vector<std::string> m_aliases;
    SlangNames m_names;
    SlangSampling m_sampling;
    SlangDefaults m_defaults;
    std::vector<std::string> m_pass_names;
    std::set<std::string> m_parameter_ids;
    std::map<std::string, std::vector<Binding>> m_bindings;
    Look m_look;
    Diagnostics m_problems;
    Diagnostics& m_warnings;
};

void ChainLook::problem(const Pass& pass, Severity severity, std::string message) {
    Diagnostic found{pass.declared.file, pass.declared.line, std::move(message), severity};
    add_new(severity == Severity::error ? m_problems : m_warnings, std::move(found));
}

void ChainLook::check_aliases() {
    for (std::size_t i = 0; i < m_aliases.size(); ++i)
        for (std::size_t before = 0; before < i; ++before)
            if (!m_aliases[i].empty() && m_aliases[i] == m_aliases[before])
                m_problems.push_back(
                    {m_chain.preset.passes[i].declared.file, m_chain.preset.passes[i].declared.line,
                     fmt::format("passes {} and {} are both named '{}'", before, i, m_aliases[i])});
}

// Also if a pass reads feedback of the last pass, which the screen does not keep.
bool ChainLook::is_stretched() const {
    if (m_chain.preset.passes.back().scale)
        return true;
    const SlangPicture last{Of::feedback, static_cast<int>(m_chain.preset.passes.size()) - 1};
    return std::ranges::any_of(m_chain.translations, [&](const Translation& translation) {
        return std::ranges::any_of(translation.samplers, [&](const NamedSampler& sampler) {
            return m_names.find(sampler.name) == last;
        });
    });
}

Format ChainLook::format_of(std::size_t index) {
    const SlangPass& declared = m_chain.preset.passes[index];
    const SlangShader& shader = m_chain.shaders[index];
    if (declared.scale && declared.is_srgb)
        return Format::srgb8_alpha8;
    if (declared.scale && declared.is_float)
        return Format::rgba16f;
    if (shader.format.empty())
        return Format::rgba8;
    if (const auto known = slang_format(shader.format))
        return *known;
    m_problems.push_back({shader.format_declared.file, shader.format_declared.line,
                          fmt::format("unknown target format '{}'", shader.format)});
    return Format::rgba8;
}

void ChainLook::make_pass(std::size_t index) {
    const SlangPass& declared = m_chain.preset.passes[index];
    const bool is_last = index + 1 == m_chain.preset.passes.size();
    const bool is_shown = is_last && !is_stretched();
    Pass pass;
    pass.name = m_pass_names[index];
    pass.draw = Draw::quad;
    pass.vertex = m_chain.translations[index].vertex;
    pass.fragment = m_chain.translations[index].fragment;
    pass.format = is_shown ? Format::rgba8 : format_of(index);
    if (declared.scale)
        for (std::size_t side = 0; side < 2; ++side)
            pass.size[side] = side_of((*declared.scale)[side]);
    else
        pass.size.fill({is_last ? Side::By::viewport : Side::By::before, 1.0, {}});
    pass.frame_modulo = declared.frame_count_mod;
    pass.rows = is_shown ? RowOrder::bottom_first : RowOrder::top_first;
    pass.output = Encoding::display;
    pass.declared = declared.declared;
    pass.built_ins.clear();
    read_samplers(pass, index);
    read_members(pass, index);
    m_look.passes.push_back(std::move(pass));
}

std::optional<Input> ChainLook::input_of(const SlangPicture& picture, std::size_t reader) {
    const auto passes = static_cast<int>(m_pass_names.size());
    const auto index = static_cast<int>(reader);
    const auto of_pass = [&](int pass, int frames_ago, const Sampler& sampler) {
        return Input{{},
                     Input::From::pass,
                     m_pass_names[static_cast<std::size_t>(pass)],
                     frames_ago,
                     sampler};
    };
    switch (picture.of) {
        case Of::original:
            return Input{{}, Input::From::source, {}, picture.number, m_sampling.of_original()};
        case Of::source:
            if (index == 0)
                return Input{{}, Input::From::source, {}, 0, m_sampling.of_original()};
            return of_pass(index - 1, 0, m_sampling.of_source(index));
        case Of::output:
            if (picture.number >= passes)
                return std::nullopt;
            // A size may be requested before the picture is drawn.
            return of_pass(
                picture.number, 0,
                picture.number < index ? m_sampling.of_output(picture.number) : Sampler{});
        case Of::feedback:
            if (picture.number >= passes)
                return std::nullopt;
            return of_pass(picture.number, 1, m_sampling.of_feedback(picture.number));
        case Of::image:
            break;
    }
    if (picture.number >= static_cast<int>(m_chain.preset.textures.size()))
        return std::nullopt;
    return Input{{},
                 Input::From::image,
                 m_chain.preset.textures[static_cast<std::size_t>(picture.number)].name,
                 0,
                 m_sampling.of_image(picture.number)};
}

void ChainLook::check_image(const Pass& pass, const NamedSampler& sampler, int texture) {
    const SlangTexture& read = m_chain.preset.textures[static_cast<std::size_t>(texture)];
    if (is_missing(read))
        problem(pass, Severity::warning,
                fmt::format("pass '{}' reads '{}', but its picture '{}' is missing{}; it is black",
                            pass.name, sampler.name, read.file.string(),
                            similar_file(read.file, read.declared.file)));
}

void ChainLook::read_samplers(Pass& pass, std::size_t index) {
    for (const NamedSampler& sampler : m_chain.translations[index].samplers) {
        const auto meant = m_names.find(sampler.name);
        if (meant && meant->of == Of::output && meant->number >= static_cast<int>(index) &&
            meant->number < static_cast<int>(m_pass_names.size())) {
            problem(pass, Severity::error,
                    fmt::format("pass '{}' reads '{}', which is not an earlier pass", pass.name,
                                sampler.name));
            continue;
        }
        auto input = meant ? input_of(*meant, index) : std::nullopt;
        if (!input) {
            problem(pass, Severity::warning,
                    fmt::format("pass '{}' reads the unknown texture '{}'; it is black", pass.name,
                                sampler.name));
            continue;
        }
        if (meant->of == Of::image)
            check_image(pass, sampler, meant->number);
        input->uniform = sampler.uniform;
        if (std::ranges::find(pass.inputs, input->uniform, &Input::uniform) == pass.inputs.end())
            pass.inputs.push_back(std::move(*input));
    }
}

bool ChainLook::has_type(const BlockMember& member, const NumberType& type, const Pass& pass) {
    if (member.type == type)
        return true;
    problem(pass, Severity::error,
            fmt::format("pass '{}' declares '{}' as {}, but it must be {}", pass.name, member.name,
                        member.type ? with_indefinite_article(glsl_name(*member.type)) : "an array",
                        with_indefinite_article(glsl_name(type))));
    return false;
}

void ChainLook::tell(Pass& pass, const BlockMember& member, const SlangMember& meant) {
    if (!has_type(member, meant.type, pass))
        return;
    if (meant.kind)
        pass.built_ins.push_back({member.uniform, *meant.kind});
    else if (meant.number != 0.0)
        pass.set[member.uniform] = Value(meant.number);
}

void ChainLook::read_members(Pass& pass, std::size_t index) {
    constexpr NumberType four_floats{Scalar::floating, 4, 1};
    constexpr NumberType one_float{Scalar::floating, 1, 1};
    for (const BlockMember& member : m_chain.translations[index].members) {
        if (m_parameter_ids.contains(member.name)) {
            if (has_type(member, one_float, pass))
                m_bindings[member.name].push_back({static_cast<int>(index), member.uniform});
            continue;
        }
        if (const SlangMember* meant = find_slang_member(member.name)) {
            tell(pass, member, *meant);
            continue;
        }
        const auto measured = m_names.find_size(member.name);
        auto input = measured ? input_of(*measured, index) : std::nullopt;
        if (!input)
            problem(pass, Severity::warning,
                    fmt::format("pass '{}' reads the unknown uniform '{}'; it is 0", pass.name,
                                member.name));
        else if (has_type(member, four_floats, pass))
            pass.built_ins.push_back({member.uniform, BuiltIn::input_extent, std::move(input)});
    }
}

void ChainLook::add_images() {
    for (std::size_t i = 0; i < m_chain.preset.textures.size(); ++i) {
        const SlangTexture& texture = m_chain.preset.textures[i];
        if (is_missing(texture))
            continue;
        Image image{texture.name, texture.file, m_sampling.of_image(static_cast<int>(i))};
        image.is_linear = true;
        image.rows = RowOrder::top_first;
        image.format = Format::rgba8;
        image.is_needed = false;
        m_look.images.push_back(std::move(image));
    }
}

void ChainLook::add_stretch() {
    Pass pass;
    pass.name = "picture";
    for (int copy = 2; find_pass(m_look, pass.name); ++copy)
        pass.name = fmt::format("picture-{}", copy);
    pass.draw = Draw::quad;
    pass.vertex = builtin_stage(stretching_corners);
    pass.fragment = builtin_stage(stretching);
    pass.format = Format::rgba8;
    pass.inputs = {{"image",
                    Input::From::pass,
                    m_pass_names.back(),
                    0,
                    {m_defaults.filter, Wrap::edge, false}}};
    pass.output = Encoding::display;
    pass.declared = m_chain.preset.passes.back().declared;
    m_look.passes.push_back(std::move(pass));
}

void ChainLook::add_parameters() {
    SlangParameters declared;
    for (const SlangShader& shader : m_chain.shaders)
        declared.insert(declared.end(), shader.parameters.begin(), shader.parameters.end());
    std::set<std::string> read;
    for (const auto& [name, bindings] : m_bindings)
        read.insert(name);
    SlangControls controls =
        slang_controls(unique_slang_parameters(declared, m_warnings), m_chain.preset.values, read);
    m_warnings.insert(m_warnings.end(), controls.warnings.begin(), controls.warnings.end());
    m_look.groups = std::move(controls.groups);
    m_look.parameters = std::move(controls.parameters);
    for (Parameter& parameter : m_look.parameters) {
        parameter.bindings = std::move(m_bindings[parameter.name]);
        parameter.is_hidden = parameter.bindings.empty();  // not read by any shader
    }
    for (const auto& [name, value] : controls.fixed)
        for (const Binding& binding : m_bindings[name])
            m_look.passes[static_cast<std::size_t>(binding.pass)].set[binding.uniform] = value;
}

Result<Look> ChainLook::make() {
    for (const SlangShader& shader : m_chain.shaders)
        for (const auto& parameter : shader.parameters)
            m_parameter_ids.insert(parameter->id);
    check_aliases();
    for (std::size_t i = 0; i < m_chain.preset.passes.size(); ++i)
        make_pass(i);
    if (!m_problems.empty())
        return fail(std::move(m_problems));
    if (is_stretched())
        add_stretch();
    add_images();
    add_parameters();
    return std::move(m_look);
}
}  // namespace

Result<Look> look_of_chain(const TranslatedChain& chain, const SlangDefaults& defaults,
                           Diagnostics& warnings) {
    return ChainLook(chain, defaults, warnings).make();
}
