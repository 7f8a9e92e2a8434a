#pragma once

#include <glslang/Public/ShaderLang.h>

#include <map>
#include <string>

/// The line on which each uniform of a text is declared, found by the text's tokens; where a name
/// is there twice or may come out of a macro, by those that glslang's preprocessor lets through.
std::map<std::string, int> find_uniform_lines(const std::string& text, EShLanguage language);
