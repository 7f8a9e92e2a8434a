#pragma once

#include "model/look/parameter.h"

#include <optional>
#include <string_view>
#include <vector>

/// A uniform that Afterglow sets; it has no control.
struct BuiltInDeclaration {
    std::string_view name;
    NumberType type;
};

const std::vector<BuiltInDeclaration>& builtin_uniforms();

/// Null when the name is not built in.
const BuiltInDeclaration* find_builtin_uniform(std::string_view name);
