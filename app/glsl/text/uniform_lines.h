#pragma once

#include <glslang/Public/ShaderLang.h>

#include <map>
#include <string>

/// The line of each uniform's declaration, from the text's tokens. If a name is declared twice or a
/// macro may declare uniforms, glslang's preprocessed text takes precedence.
std::map<std::string, int> find_uniform_lines(const std::string& text, EShLanguage language);
