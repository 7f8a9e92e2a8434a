#pragma once

#include "model/look/format.h"

#include <optional>
#include <string_view>

/// The format of a `#pragma format` such as "R16G16B16A16_SFLOAT"; nullopt for other names.
std::optional<Format> slang_format(std::string_view name);

/// The name of a format.
std::string_view slang_format_name(Format format);
