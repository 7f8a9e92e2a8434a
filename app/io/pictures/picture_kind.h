#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// The number of bytes from a file's start that picture_kind needs.
constexpr std::size_t picture_start = 12;

/// OpenImageIO's name of the format that starts with these bytes; "" if not supported. Without a
/// name the library tries all formats. Some of them read all of a huge file before they reject it.
std::string picture_kind(std::string_view start, const std::filesystem::path& file);
