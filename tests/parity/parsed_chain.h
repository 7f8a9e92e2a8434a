#pragma once

#include "formats/slang/preset.h"
#include "formats/slang/shader.h"
#include "glsl/compile/translate.h"

/// A preset's numbers and its shaders' texts, as the program reads them, and nothing that the
/// program makes of them.
struct ParsedChain {
    SlangPreset preset;
    std::vector<SlangShader> shaders;       // one a pass
    std::vector<Translation> translations;  // likewise
};

Result<ParsedChain> parse_chain(const std::filesystem::path& preset);
