#include "glsl/es/es_program.h"

#include "base/text.h"
#include "glsl/compile/compiler_log.h"
#include "glsl/compile/version_line.h"
#include "glsl/es/es_check.h"
#include "glsl/es/es_source.h"
#include "glsl/es/nested_arrays.h"
#include "glsl/limits/start.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv_cross/spirv_glsl.hpp>

#include <array>
#include <unordered_set>
#include <utility>

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

Result<std::string> preprocessed(const Stage& stage, EShLanguage language,
                                 const std::vector<EsConstant>& constants) {
    const std::string text =
        with_es_constants(with_nested_arrays(without_line_directives(stage.text)), constants);
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

/// What a translation depends on besides its texts.
struct Terms {
    const std::map<std::string, Sampler>& samplers;
    const std::vector<EsConstant>& constants;
    bool is_impure;
};

/// A stage on its way to SPIR-V for OpenGL.
class DesktopStage {
public:
    DesktopStage(const Stage& stage, EShLanguage language)
        : m_stage(stage), m_language(language), m_shader(language) {}

    Result<void> parse(const Terms& terms) {
        auto text = preprocessed(m_stage, m_language, terms.constants);
        if (!text)
            return fail(text.error());
        m_text = es_source(*text, terms.samplers, {m_language == EShLangFragment, terms.is_impure});
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

/// Writes a stage in GLSL ES.
class EsCompiler {
public:
    explicit EsCompiler(std::vector<std::uint32_t> code)
        : m_compiler(without_nested_arrays(std::move(code))),
          m_active(m_compiler.get_active_interface_variables()),
          m_resources(m_compiler.get_shader_resources()) {
        spirv_cross::CompilerGLSL::Options options;
        options.version = es_version;
        options.es = true;
        options.fragment.default_float_precision = options.Highp;
        options.fragment.default_int_precision = options.Highp;
        options.vertex.support_nonzero_base_instance = false;
        m_compiler.set_common_options(options);
        for (const auto& sampler : m_resources.sampled_images) {
            m_compiler.unset_decoration(sampler.id, spv::DecorationDescriptorSet);
            m_compiler.unset_decoration(sampler.id, spv::DecorationBinding);
        }
        // Quads are flat, and pixels have one sample.
        for (const auto* const varyings : {&m_resources.stage_inputs, &m_resources.stage_outputs})
            for (const auto& varying : *varyings) {
                m_compiler.unset_decoration(varying.id, spv::DecorationNoPerspective);
                m_compiler.unset_decoration(varying.id, spv::DecorationSample);
            }
    }

    /// Gives the outputs that the next stage reads its names. GLSL ES connects stages by name.
    void connect(EsCompiler& next) {
        for (const auto& output : m_resources.stage_outputs)
            for (const auto& input : next.m_resources.stage_inputs) {
                const std::uint32_t location = location_of(output);
                if (location != next.location_of(input) || !next.m_active.contains(input.id))
                    continue;
                m_active.insert(output.id);  // even if it is never written
                for (const auto& [compiler, id] :
                     {std::pair{this, output.id}, std::pair{&next, input.id}}) {
                    if (output.name != input.name)
                        compiler->m_compiler.set_name(id, fmt::format("es_varying_{}", location));
                }
            }
    }

    std::string text() {
        m_compiler.set_enabled_interface_variables(m_active);
        return m_compiler.compile();
    }

private:
    std::uint32_t location_of(const spirv_cross::Resource& resource) const {
        return m_compiler.get_decoration(resource.id, spv::DecorationLocation);
    }

    spirv_cross::CompilerGLSL m_compiler;
    std::unordered_set<spirv_cross::VariableID> m_active;
    spirv_cross::ShaderResources m_resources;
};

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
                                        const Terms& terms) {
    DesktopStage vertex_stage(vertex, EShLangVertex);
    DesktopStage fragment_stage(fragment, EShLangFragment);
    glslang::TProgram program;
    for (DesktopStage* stage : std::array{&vertex_stage, &fragment_stage}) {
        if (auto parsed = stage->parse(terms); !parsed)
            return fail(parsed.error());
        program.addShader(&stage->shader());
    }
    if (!program.link(EShMsgSpvRules) || !program.mapIO())
        return fail(lacking(fragment, first_error(program.getInfoLog())));
    return DesktopCode{code_of(program, EShLangVertex), code_of(program, EShLangFragment)};
}

// SPIRV-Cross suggests its own options.
std::string feature_of(const std::string& message) {
    return message.starts_with("Arrays of arrays") ? "an array in an array is used as a whole"
                                                   : message;
}

Result<EsProgram> written_es(DesktopCode code, const Stage& fragment) {
    try {
        EsCompiler vertex_compiler(std::move(code.vertex));
        EsCompiler fragment_compiler(std::move(code.fragment));
        vertex_compiler.connect(fragment_compiler);
        return EsProgram{vertex_compiler.text(), fragment_compiler.text()};
    } catch (const spirv_cross::CompilerError& error) {
        return fail(lacking(fragment, feature_of(error.what())));
    }
}

// Built-in functions of later versions are written unchanged.
Result<void> check_es(const std::string& text, const Stage& author, bool is_fragment) {
    const std::string error = es_error(text, is_fragment);
    return error.empty() ? Result<void>() : fail(lacking(author, error));
}
}  // namespace

Result<EsProgram> translate_to_es(const Stage& vertex, const Stage& fragment,
                                  const std::map<std::string, Sampler>& samplers,
                                  const std::vector<EsConstant>& constants) {
    start_glslang();
    Result<EsProgram> program = fail({fragment.file, 0, ""});
    // SPIRV-Cross fails on some functions that only write their own variables.
    for (const bool is_impure : {false, true}) {
        auto code = compile_for_desktop(vertex, fragment, {samplers, constants, is_impure});
        if (!code)
            return fail(code.error());
        program = written_es(std::move(*code), fragment);
        if (program)
            break;
    }
    if (!program)
        return program;
    if (auto good = check_es(program->vertex, vertex, false); !good)
        return fail(good.error());
    if (auto good = check_es(program->fragment, fragment, true); !good)
        return fail(good.error());
    return program;
}
