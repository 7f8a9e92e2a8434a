#pragma once

#include "glsl/compile/check.h"
#include "glsl/compile/translate.h"

#include <optional>
#include <string>
#include <string_view>

/// Serialises results about shaders. Unpacking returns nullopt for invalid bytes.
std::string packed(const Reflection& reflection);
std::string packed(const Translation& translation);
std::optional<Reflection> unpacked_reflection(std::string_view bytes);
std::optional<Translation> unpacked_translation(std::string_view bytes);
