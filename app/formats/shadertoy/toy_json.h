#pragma once

#include "formats/shadertoy/toy.h"

#include <filesystem>

/// Whether a JSON text is a shader of Shadertoy, told without reading all of it; so is a web page
/// that was saved as one, of which parse_toy_json() says so.
bool is_toy_json(std::string_view text);

/// Reads one in either dialect: as the site's API answers ({"Shader": {...}}), or as the site
/// exports (bare, the only element of a list, or the only one of all shaders of a person). The code
/// of a pass lies in the file "FILE/PASS" as far as its lines are told. Errors: JSON's, and what is
/// no such shader. `warnings` gets what is passed over, by name.
Result<Toy> parse_toy_json(std::string_view text, const std::filesystem::path& file,
                           Diagnostics& warnings);
