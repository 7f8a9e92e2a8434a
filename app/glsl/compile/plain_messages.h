#pragma once

#include "glsl/compile/built_in_names.h"
#include "glsl/compile/compiler_log.h"

#include <string>
#include <vector>

/// Rewrites glslang's messages about a text in plain English: GLSL's names of types, the fields of
/// the struct at hand, and similar names for a name that is not declared ("did you mean"). A
/// rewritten message starts with the quoted part of the source line that it is about. Messages
/// without a line, and unknown ones, keep their words.
void explain(std::vector<CompilerMessage>& messages, const std::string& text,
             const Dialect& dialect);
