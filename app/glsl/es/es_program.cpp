#include "glsl/es/es_program.h"

#include "glsl/compile/compiler_log.h"
#include "glsl/es/es_check.h"
#include "glsl/es/es_source.h"
#include "glsl/limits/start.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv_cross/spirv_glsl.hpp>

#include <array>

namespace {
constexpr int desktop_version = 410;
constexpr int es_version = 300;

Diagnostic lacking(const Stage& stage, const std::string& reason) {
    return {stage.file, 0, fmt::format("GLSL ES 3.00 can't express the shader: {}", reason)};
}

// The first error of a log, without position.
std::string first_error(const char* log) {
    for (const CompilerMessage& message : parse_compiler_log(log))
        if (!message.is_warning)
            return message.text;
    return refused_without_reason;
}

Result<std::string> preprocessed(const Stage& stage, EShLanguage language) {
    const std::string text = without_line_directives(stage.text);
    glslang::TShader shader(language);
    const char* const piece = text.c_str();
    shader.setStrings(&piece, 1);
    glslang::TShader::ForbidIncluder no_includes;
    std::string result;
    if (!shader.preprocess(GetDefaultResources(), desktop_version, ECoreProfile, false, false,
                           EShMsgDefault, &result, no_includes))
        return fail({stage.file, 0, first_error(shader.getInfoLog())});
    return without_line_directives(std::move(result));
}

/// A stage on its way to SPIR-V for OpenGL.
class DesktopStage {
public:
    DesktopStage(const Stage& stage, EShLanguage language)
        : m_stage(stage), m_language(language), m_shader(language) {}

    Result<void> parse(const std::map<std::string, Sampler>& samplers) {
        auto text = preprocessed(m_stage, m_language);
        if (!text)
            return fail(text.error());
        m_text = es_source(*text, samplers, m_language == EShLangFragment);
        m_piece = m_text.c_str();
        m_shader.setStrings(&m_piece, 1);
        m_shader.setEnvInput(glslang::EShSourceGlsl, m_language, glslang::EShClientOpenGL, 100);
        m_shader.setEnvClient(glslang::EShClientOpenGL, glslang::EShTargetOpenGL_450);
        m_shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
        m_shader.setAutoMapLocations(true);
        m_shader.setAutoMapBindings(true);
        if (!m_shader.parse(GetDefaultResources(), desktop_version, ECoreProfile, false, false,
                            EShMsgSpvRules))
            return fail(lacking(m_stage, first_error(m_shader.getInfoLog())));
        return {};
    }

    glslang::TShader& shader() { return m_shader; }

private:
    const Stage& m_stage;
    EShLanguage m_language;
    std::string m_text;
    const char* m_piece = nullptr;
    glslang::TShader m_shader;
};

std::string written_es(std::vector<std::uint32_t> code) {
    spirv_cross::CompilerGLSL compiler(std::move(code));
    spirv_cross::CompilerGLSL::Options options;
    options.version = es_version;
    options.es = true;
    options.fragment.default_float_precision = options.Highp;
    options.fragment.default_int_precision = options.Highp;
    options.vertex.support_nonzero_base_instance = false;
    compiler.set_common_options(options);
    const auto active = compiler.get_active_interface_variables();
    compiler.set_enabled_interface_variables(active);
    for (const auto& sampler : compiler.get_shader_resources(active).sampled_images) {
        compiler.unset_decoration(sampler.id, spv::DecorationDescriptorSet);
        compiler.unset_decoration(sampler.id, spv::DecorationBinding);
    }
    return compiler.compile();
}

std::vector<std::uint32_t> code_of(const glslang::TProgram& program, EShLanguage language) {
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    std::vector<std::uint32_t> code;
    spv::SpvBuildLogger logger;
    glslang::GlslangToSpv(*program.getIntermediate(language), code, &logger, &options);
    return code;
}

/// Both stages as SPIR-V for OpenGL.
struct DesktopCode {
    std::vector<std::uint32_t> vertex;
    std::vector<std::uint32_t> fragment;
};

Result<DesktopCode> compile_for_desktop(const Stage& vertex, const Stage& fragment,
                                        const std::map<std::string, Sampler>& samplers) {
    DesktopStage vertex_stage(vertex, EShLangVertex);
    DesktopStage fragment_stage(fragment, EShLangFragment);
    glslang::TProgram program;
    for (DesktopStage* stage : std::array{&vertex_stage, &fragment_stage}) {
        if (auto parsed = stage->parse(samplers); !parsed)
            return fail(parsed.error());
        program.addShader(&stage->shader());
    }
    if (!program.link(EShMsgSpvRules) || !program.mapIO())
        return fail(lacking(fragment, first_error(program.getInfoLog())));
    return DesktopCode{code_of(program, EShLangVertex), code_of(program, EShLangFragment)};
}

Result<std::string> es_text(std::vector<std::uint32_t> code, const Stage& author,
                            EShLanguage language) {
    std::string text;
    try {
        text = written_es(std::move(code));
    } catch (const spirv_cross::CompilerError& error) {
        return fail(lacking(author, error.what()));
    }
    // Built-in functions of later versions are written unchanged.
    if (const std::string error = es_error(text, language == EShLangFragment); !error.empty())
        return fail(lacking(author, error));
    return text;
}
}  // namespace

Result<EsProgram> translate_to_es(const Stage& vertex, const Stage& fragment,
                                  const std::map<std::string, Sampler>& samplers) {
    start_glslang();
    auto code = compile_for_desktop(vertex, fragment, samplers);
    if (!code)
        return fail(code.error());
    auto vertex_text = es_text(std::move(code->vertex), vertex, EShLangVertex);
    if (!vertex_text)
        return fail(vertex_text.error());
    auto fragment_text = es_text(std::move(code->fragment), fragment, EShLangFragment);
    if (!fragment_text)
        return fail(fragment_text.error());
    return EsProgram{std::move(*vertex_text), std::move(*fragment_text)};
}
