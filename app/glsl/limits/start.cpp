#include "glsl/limits/start.h"

#include <glslang/Public/ShaderLang.h>

void start_glslang() {
    static const bool started = glslang::InitializeProcess();
    static_cast<void>(started);
}
