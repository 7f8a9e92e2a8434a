#include "glsl/es/es_check.h"

#include "glsl/compile/compiler_log.h"
#include "glsl/limits/start.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

std::string es_error(const std::string& text, bool is_fragment) {
    constexpr int es_version = 300;
    start_glslang();
    glslang::TShader shader(is_fragment ? EShLangFragment : EShLangVertex);
    const char* const piece = text.c_str();
    shader.setStrings(&piece, 1);
    if (shader.parse(GetDefaultResources(), es_version, EEsProfile, false, false, EShMsgDefault))
        return {};
    for (const CompilerMessage& message : parse_compiler_log(shader.getInfoLog()))
        if (!message.is_warning)
            return message.text;
    return refused_without_reason;
}
