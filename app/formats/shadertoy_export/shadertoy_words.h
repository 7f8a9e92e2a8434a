#pragma once

#include "formats/glsl/modern_glsl.h"
#include "model/look/format.h"

#include <set>
#include <string>
#include <string_view>

/// Whether the site declares the name.
bool is_shadertoy_word(std::string_view name);

/// Names of the site, and of functions that passes get.
std::set<std::string, std::less<>> shadertoy_reserved_names();

/// A function or type that passes can't have, "" if there is none.
std::string unusable_word(const GlslWords& words);

/// What a format with few bits or channels stores of `color`, as GLSL; "" for the whole color.
std::string stored_value(Format format);

/// Whether a call of texture() in a text has three arguments.
bool calls_with_bias(std::string_view text);
