#include "glsl/stages/stage_code.h"

#include "glsl/compile/compiler_log.h"
#include "glsl/limits/start.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv-tools/libspirv.hpp>
#include <spirv_cross/spirv_hlsl.hpp>
#include <spirv_cross/spirv_msl.hpp>
#include <spirv_cross/spirv_reflect.hpp>

#include <array>

namespace {
using Words = std::vector<std::uint32_t>;

constexpr int desktop_version = 410;
constexpr auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);

std::string first_error(const char* log) {
    for (const CompilerMessage& message : parse_compiler_log(log))
        if (!message.is_warning)
            return message.text;
    return refused_without_reason;
}

/// A GLSL 4.10 stage, compiled for Vulkan with its plain uniforms in a block.
class VulkanLikeStage {
public:
    VulkanLikeStage(const Stage& stage, EShLanguage language)
        : m_text(without_line_directives(stage.text)), m_shader(language) {
        m_piece = m_text.c_str();
        m_shader.setStrings(&m_piece, 1);
        m_shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
        m_shader.setEnvInputVulkanRulesRelaxed();
        m_shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
        m_shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
        m_shader.setGlobalUniformBlockName("Uniforms");
        m_shader.setGlobalUniformBinding(0);
        m_shader.setAutoMapLocations(true);
        m_shader.setAutoMapBindings(true);
    }

    std::string parse() {
        const bool is_good = m_shader.parse(GetDefaultResources(), desktop_version, ECoreProfile,
                                            false, false, messages);
        return is_good ? std::string() : first_error(m_shader.getInfoLog());
    }
    glslang::TShader& shader() { return m_shader; }

private:
    std::string m_text;
    const char* m_piece = nullptr;
    glslang::TShader m_shader;
};

Words words_of(const glslang::TProgram& program, EShLanguage language) {
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    Words words;
    spv::SpvBuildLogger logger;
    glslang::GlslangToSpv(*program.getIntermediate(language), words, &logger, &options);
    return words;
}

Result<std::array<Words, 2>> compile(const Stage& vertex, const Stage& fragment) {
    VulkanLikeStage vertex_stage(vertex, EShLangVertex);
    VulkanLikeStage fragment_stage(fragment, EShLangFragment);
    glslang::TProgram program;
    for (auto [stage, author] :
         {std::pair{&vertex_stage, &vertex}, std::pair{&fragment_stage, &fragment}}) {
        if (const std::string error = stage->parse(); !error.empty())
            return fail({author->file, 0, error});
        program.addShader(&stage->shader());
    }
    if (!program.link(messages) || !program.mapIO())
        return fail({fragment.file, 0, first_error(program.getInfoLog())});
    return std::array{words_of(program, EShLangVertex), words_of(program, EShLangFragment)};
}

std::string bytes_of(const Words& words) {
    std::string bytes;
    bytes.reserve(words.size() * 4);
    for (const std::uint32_t word : words)
        for (unsigned int shift = 0; shift < 32; shift += 8)
            bytes += static_cast<char>(word >> shift & 255u);
    return bytes;
}

std::string spirv_fault(const Words& words) {
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_0);
    std::string fault;
    tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&,
                                 const char* message) { fault = message; });
    return tools.Validate(words) ? std::string() : fault;
}

// glslang reads the HLSL of Shader Model 5.
std::string hlsl_fault(const std::string& text, EShLanguage language) {
    glslang::TShader shader(language);
    const char* const piece = text.c_str();
    shader.setStrings(&piece, 1);
    shader.setEnvInput(glslang::EShSourceHlsl, language, glslang::EShClientVulkan, 100);
    shader.setEntryPoint("main");
    shader.setAutoMapBindings(true);
    const auto hlsl = static_cast<EShMessages>(EShMsgReadHlsl | EShMsgSpvRules | EShMsgVulkanRules);
    constexpr int hlsl_version = 500;
    return shader.parse(GetDefaultResources(), hlsl_version, ENoProfile, false, false, hlsl)
               ? std::string()
               : first_error(shader.getInfoLog());
}

template <class Compiler>
std::string written_by(Compiler& compiler, const char* language, StageCode& code) {
    try {
        return compiler.compile();
    } catch (const spirv_cross::CompilerError& error) {
        code.faults[language] = error.what();
        return {};
    }
}

StageCode code_of(const Words& words, EShLanguage language) {
    StageCode code;
    code.spirv = bytes_of(words);
    spirv_cross::CompilerHLSL hlsl(words);
    spirv_cross::CompilerHLSL::Options options;
    options.shader_model = 50;
    options.point_size_compat = true;  // Direct3D has no points larger than a pixel
    options.point_coord_compat = true;
    hlsl.set_hlsl_options(options);
    code.hlsl = written_by(hlsl, "hlsl", code);
    spirv_cross::CompilerMSL msl(words);
    code.msl = written_by(msl, "msl", code);
    spirv_cross::CompilerReflection reflection(words);
    code.reflection = written_by(reflection, "reflection", code);
    if (const std::string fault = spirv_fault(words); !fault.empty())
        code.faults["spirv"] = fault;
    if (!code.hlsl.empty())
        if (const std::string fault = hlsl_fault(code.hlsl, language); !fault.empty())
            code.faults["hlsl"] = fault;
    return code;
}
}  // namespace

Result<PassCode> stage_code(const Stage& vertex, const Stage& fragment) {
    start_glslang();
    const auto words = compile(vertex, fragment);
    if (!words)
        return fail(words.error());
    return PassCode{code_of((*words)[0], EShLangVertex), code_of((*words)[1], EShLangFragment)};
}
