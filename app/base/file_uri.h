#pragma once

#include <filesystem>
#include <string_view>

/// The path of a "file:" URI without its escapes; "": not such a URI, or one of another machine.
std::filesystem::path path_of_uri(std::string_view uri);
