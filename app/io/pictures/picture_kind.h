#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// How many bytes of a file's start picture_kind looks at.
constexpr std::size_t picture_start = 12;

/// The name that OpenImageIO has for the format that a file of this start is in; "" for none that
/// is read. Left to itself the library would try every format it knows, and some of them read all
/// of a huge file before they find that it is not theirs.
std::string picture_kind(std::string_view start, const std::filesystem::path& file);
