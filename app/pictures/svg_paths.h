#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string>
#include <string_view>

/// See PictureCodec::svg_paths.
Result<std::string> svg_paths(std::string_view bytes, const std::filesystem::path& file);
