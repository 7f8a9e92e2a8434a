#include "glsl/hlsl/fragment_hlsl.h"

#include "glsl/compile/compiler_log.h"
#include "glsl/compile/version_line.h"
#include "glsl/es/es_source.h"
#include "glsl/es/nested_arrays.h"
#include "glsl/limits/start.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv_cross/spirv_hlsl.hpp>

namespace fs = std::filesystem;

namespace {
using Words = std::vector<std::uint32_t>;

constexpr int desktop_version = 410;

std::string first_error(const char* log) {
    for (const CompilerMessage& message : parse_compiler_log(log))
        if (!message.is_warning)
            return message.text;
    return refused_without_reason;
}

Result<std::string> preprocessed(const std::string& text, const fs::path& file) {
    const std::string given = with_nested_arrays(without_line_directives(text));
    const char* const piece = given.c_str();
    glslang::TShader shader(EShLangFragment);
    shader.setStrings(&piece, 1);
    glslang::TShader::ForbidIncluder no_includes;
    std::string result;
    if (!shader.preprocess(GetDefaultResources(), desktop_version, ECoreProfile, false, false,
                           EShMsgDefault, &result, no_includes))
        return fail({file, 0, first_error(shader.getInfoLog())});
    return without_line_directives(std::move(result));
}

// SPIR-V for OpenGL, which has plain uniforms.
Result<Words> compile(const std::string& text, const fs::path& file) {
    glslang::TShader shader(EShLangFragment);
    const char* const piece = text.c_str();
    shader.setStrings(&piece, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangFragment, glslang::EShClientOpenGL, 100);
    shader.setEnvClient(glslang::EShClientOpenGL, glslang::EShTargetOpenGL_450);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
    shader.setAutoMapLocations(true);
    shader.setAutoMapBindings(true);
    if (!shader.parse(GetDefaultResources(), desktop_version, ECoreProfile, false, false,
                      EShMsgSpvRules))
        return fail({file, 0, first_error(shader.getInfoLog())});
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(EShMsgSpvRules) || !program.mapIO())
        return fail({file, 0, first_error(program.getInfoLog())});
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    Words words;
    spv::SpvBuildLogger logger;
    glslang::GlslangToSpv(*program.getIntermediate(EShLangFragment), words, &logger, &options);
    return words;
}

Result<std::string> written_hlsl(Words words, const fs::path& file) {
    try {
        spirv_cross::CompilerHLSL compiler(without_nested_arrays(std::move(words)));
        spirv_cross::CompilerHLSL::Options options;
        options.shader_model = 50;
        compiler.set_hlsl_options(options);
        return compiler.compile();
    } catch (const spirv_cross::CompilerError& error) {
        return fail({file, 0, fmt::format("HLSL can't express the shader: {}", error.what())});
    }
}
}  // namespace

Result<std::string> fragment_hlsl(const std::string& text, const fs::path& file) {
    start_glslang();
    const auto plain = preprocessed(text, file);
    if (!plain)
        return fail(plain.error());
    Result<std::string> hlsl = fail({file, 0, ""});
    // SPIRV-Cross fails on some functions that only write their own variables.
    for (const bool is_impure : {false, true}) {
        auto words = compile(es_source(*plain, {}, {true, is_impure}), file);
        if (!words)
            return fail(words.error());
        hlsl = written_hlsl(std::move(*words), file);
        if (hlsl)
            break;
    }
    return hlsl;
}
