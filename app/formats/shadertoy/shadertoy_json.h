#pragma once

#include "formats/shadertoy/shadertoy.h"

#include <filesystem>

/// Whether a JSON text is a Shadertoy shader, without parsing it. Also true for a saved web page,
/// which parse_shadertoy_json() reports.
bool is_shadertoy_json(std::string_view text);

/// Parses either dialect. Response of the site's API: {"Shader": {...}}. Export of the site: bare,
/// the only element of a list, or the only shader of a user's export. The file of a pass's code in
/// errors is "FILE/PASS". Errors: JSON errors and other JSON. `warnings` receives ignored parts, by
/// name.
Result<Shadertoy> parse_shadertoy_json(std::string_view text, const std::filesystem::path& file,
                                       Diagnostics& warnings);
