#pragma once

#include "glsl/compile/check.h"
#include "glsl/compile/translate.h"

#include <optional>
#include <string>
#include <string_view>

/// Answers about shaders as bytes and back; none where the bytes are no such answer.
std::string packed(const Reflection& reflection);
std::string packed(const Translation& translation);
std::optional<Reflection> unpacked_reflection(std::string_view bytes);
std::optional<Translation> unpacked_translation(std::string_view bytes);
