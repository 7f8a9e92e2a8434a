#include "glsl/compile/translate.h"

#include "glsl/compile/check.h"
#include "glsl/compile/spirv.h"

#include <fmt/format.h>
#include <spirv_cross/spirv_glsl.hpp>

#include <map>
#include <set>
#include <string_view>

namespace {
using spirv_cross::Resource;

constexpr std::uint32_t written_version = 410;

std::optional<NumberType> number_type(const spirv_cross::SPIRType& type) {
    if (!type.array.empty())
        return std::nullopt;
    NumberType number{Scalar::floating, static_cast<int>(type.vecsize),
                      static_cast<int>(type.columns)};
    switch (type.basetype) {
        case spirv_cross::SPIRType::Float:
            return number;
        case spirv_cross::SPIRType::Int:
            number.scalar = Scalar::integer;
            return number;
        case spirv_cross::SPIRType::UInt:
            number.scalar = Scalar::unsigned_integer;
            return number;
        default:
            return std::nullopt;
    }
}

/// Translates one stage from SPIR-V to GLSL. The caller catches the library's exceptions.
class Translator {
public:
    Translator(std::vector<std::uint32_t> code, const Stage& author, std::string_view stage)
        : m_compiler(std::move(code)), m_author(author), m_stage(stage) {
        m_compiler.set_enabled_interface_variables(m_compiler.get_active_interface_variables());
        m_resources = m_compiler.get_shader_resources(m_compiler.get_active_interface_variables());
    }

    void check(Diagnostics& problems) const;
    std::set<std::uint32_t> flat_inputs() const;
    void make_flat(const std::set<std::uint32_t>& locations);
    /// Returns the stage's text and adds its members and samplers to `into`.
    Stage translate(Translation& into);

private:
    void name_block(const Resource& block, std::string_view kind);
    void add_members(const Resource& block, const std::vector<std::string>& names,
                     Translation& into) const;
    std::vector<std::string> member_names(const Resource& block) const;
    Stage with_lines(const std::string& text) const;

    spirv_cross::CompilerGLSL m_compiler;
    spirv_cross::ShaderResources m_resources;
    const Stage& m_author;
    std::string m_stage;
};

void Translator::check(Diagnostics& problems) const {
    // A refusal has a {} for the stage and one for the unsupported resource.
    const auto refuse = [&](const auto& resources, std::size_t maximum, std::string_view refusal) {
        if (resources.size() > maximum)
            problems.push_back(
                {m_author.file, 0,
                 fmt::format(fmt::runtime(refusal), m_stage, resources[maximum].name)});
    };
    refuse(m_resources.uniform_buffers, 1, "the {} stage has a second uniform block, '{}'");
    refuse(m_resources.push_constant_buffers, 1,
           "the {} stage has a second push constant block, '{}'");
    refuse(m_resources.storage_buffers, 0,
           "the {} stage has a storage buffer, '{}'; storage buffers aren't supported");
    refuse(m_resources.storage_images, 0,
           "the {} stage has a storage image, '{}'; storage images aren't supported");
    refuse(m_resources.separate_images, 0, "the {} stage has a texture without a sampler, '{}'");
    refuse(m_resources.separate_samplers, 0, "the {} stage has a sampler without a texture, '{}'");
    refuse(m_resources.subpass_inputs, 0,
           "the {} stage has a subpass input, '{}'; subpass inputs aren't supported");
}

std::set<std::uint32_t> Translator::flat_inputs() const {
    std::set<std::uint32_t> flat;
    for (const Resource& input : m_resources.stage_inputs)
        if (m_compiler.has_decoration(input.id, spv::DecorationFlat))
            flat.insert(m_compiler.get_decoration(input.id, spv::DecorationLocation));
    return flat;
}

// Drivers require the same qualifier in both stages; Vulkan does not.
void Translator::make_flat(const std::set<std::uint32_t>& locations) {
    for (const Resource& output : m_resources.stage_outputs)
        if (locations.contains(m_compiler.get_decoration(output.id, spv::DecorationLocation)))
            m_compiler.set_decoration(output.id, spv::DecorationFlat);
        else
            m_compiler.unset_decoration(output.id, spv::DecorationFlat);
}

// Plain uniforms of both stages are matched by name, and blocks with the same name may differ.
void Translator::name_block(const Resource& block, std::string_view kind) {
    m_compiler.set_name(block.base_type_id, fmt::format("{}_{}_type", m_stage, kind));
    m_compiler.set_name(block.id, fmt::format("{}_{}", m_stage, kind));
}

std::vector<std::string> Translator::member_names(const Resource& block) const {
    std::vector<std::string> names;
    const std::size_t count = m_compiler.get_type(block.base_type_id).member_types.size();
    for (std::uint32_t i = 0; i < count; ++i)
        names.push_back(m_compiler.get_member_name(block.base_type_id, i));
    return names;
}

void Translator::add_members(const Resource& block, const std::vector<std::string>& names,
                             Translation& into) const {
    const spirv_cross::SPIRType& type = m_compiler.get_type(block.base_type_id);
    std::set<std::uint32_t> read;
    for (const spirv_cross::BufferRange& range : m_compiler.get_active_buffer_ranges(block.id))
        read.insert(range.index);
    for (const std::uint32_t i : read) {
        const std::string name = m_compiler.get_member_name(block.base_type_id, i);
        into.members.push_back({names[i], fmt::format("{}.{}", m_compiler.get_name(block.id), name),
                                number_type(m_compiler.get_type(type.member_types[i]))});
    }
}

// Core since GLSL 4.20.
bool packs_halves(std::string_view text) {
    return text.find("packHalf2x16(") != std::string_view::npos ||
           text.find("packSnorm2x16(") != std::string_view::npos;
}

// Converts the library's #line directives to source locations and removes them.
Stage Translator::with_lines(const std::string& text) const {
    constexpr std::string_view mark = "#line ";
    Stage stage{m_author.file, {}, {}};
    Location at{m_author.file, 0};
    for (const std::string_view line : split_lines(text)) {
        const std::string_view words = trim(line);
        if (words.starts_with("#extension GL_GOOGLE_cpp_style_line_directive"))
            continue;
        if (words.starts_with(mark)) {
            const std::string_view number = words.substr(mark.size());
            at = location_in(m_author,
                             parse_integer(number.substr(0, number.find(' '))).value_or(0));
            continue;
        }
        stage.text.own() += line;
        stage.text.own() += '\n';
        stage.lines.push_back(at);
        if (words.starts_with("#version") && packs_halves(text)) {
            stage.text.own() += "#extension GL_ARB_shading_language_packing : require\n";
            stage.lines.push_back(at);
        }
    }
    return stage;
}

Stage Translator::translate(Translation& into) {
    spirv_cross::CompilerGLSL::Options options;
    options.version = written_version;
    options.enable_420pack_extension = false;
    options.emit_uniform_buffer_as_plain_uniforms = true;
    options.emit_line_directives = true;
    m_compiler.set_common_options(options);

    std::vector<std::pair<const Resource*, std::vector<std::string>>> blocks;
    for (const Resource& block : m_resources.uniform_buffers) {
        blocks.emplace_back(&block, member_names(block));
        name_block(block, "uniforms");
        m_compiler.unset_decoration(block.id, spv::DecorationDescriptorSet);
        m_compiler.unset_decoration(block.id, spv::DecorationBinding);
    }
    for (const Resource& block : m_resources.push_constant_buffers) {
        blocks.emplace_back(&block, member_names(block));
        name_block(block, "constants");
    }
    for (const Resource& sampler : m_resources.sampled_images) {
        m_compiler.unset_decoration(sampler.id, spv::DecorationDescriptorSet);
        m_compiler.unset_decoration(sampler.id, spv::DecorationBinding);
    }
    const std::string text = m_compiler.compile();
    for (const auto& [block, names] : blocks)
        add_members(*block, names, into);
    for (const Resource& sampler : m_resources.sampled_images)
        into.samplers.push_back({sampler.name, m_compiler.get_name(sampler.id)});
    return with_lines(text);
}
}  // namespace

Result<Translation> translate_from_vulkan(const Stage& vertex, const Stage& fragment,
                                          const ShaderLimits& limits) {
    auto code = compile_for_vulkan(vertex, fragment, limits);
    if (!code)
        return fail(code.error());
    try {
        Translator to_fragment(std::move(code->fragment), fragment, "fragment");
        Translator to_vertex(std::move(code->vertex), vertex, "vertex");
        Diagnostics problems;
        to_vertex.check(problems);
        to_fragment.check(problems);
        if (!problems.empty())
            return fail(std::move(problems));
        Translation translation;
        translation.warnings = std::move(code->warnings);
        to_vertex.make_flat(to_fragment.flat_inputs());
        translation.vertex = to_vertex.translate(translation);
        translation.fragment = to_fragment.translate(translation);
        return translation;
    } catch (const spirv_cross::CompilerError& error) {
        return fail({fragment.file, 0,
                     fmt::format("can't translate the shader to OpenGL: {}", error.what())});
    }
}
