#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// The path of a "file:" URI without its escapes; "": not such a URI, or one of another machine.
std::filesystem::path path_of_uri(std::string_view uri);

/// A path for a URI: all bytes except RFC 2396's unreserved characters and "/" are escaped.
std::string percent_encoded(const std::string& path);
