#pragma once

#include "formats/slang/preset.h"
#include "formats/slang/shader.h"
#include "glsl/compile/translate.h"

/// The numbers of a preset and the texts of its shaders as parsed by the program, without anything
/// derived from them.
struct ParsedChain {
    SlangPreset preset;
    std::vector<SlangShader> shaders;       // one per pass
    std::vector<Translation> translations;  // one per pass
};

Result<ParsedChain> parse_chain(const std::filesystem::path& preset);
