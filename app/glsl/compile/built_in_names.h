#pragma once

#include <glslang/Public/ShaderLang.h>

#include <string>
#include <vector>

/// How a text is compiled.
struct Dialect {
    EShLanguage stage = EShLangFragment;
    int version = 410;
    bool is_vulkan = false;
};

/// The functions and variables of GLSL itself.
struct BuiltInNames {
    std::vector<std::string> functions;  // each name once
    std::vector<std::string> variables;
};

/// Reads them from glslang's own declarations. The first time takes about 40 ms per dialect. Any
/// thread may call it.
const BuiltInNames& find_built_in_names(const Dialect& dialect);
