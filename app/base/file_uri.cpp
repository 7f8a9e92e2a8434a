#include "base/file_uri.h"

#include "base/text.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cstring>

namespace fs = std::filesystem;

fs::path path_of_uri(std::string_view uri) {
    constexpr std::string_view scheme = "file://";
    if (!to_lower(uri.substr(0, scheme.size())).starts_with(scheme))
        return {};
    uri.remove_prefix(scheme.size());
    if (uri.starts_with("localhost/"))
        uri.remove_prefix(std::string_view("localhost").size());
    if (!uri.starts_with('/'))
        return {};
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned int byte = 0;
        const char* code = uri.data() + i + 1;
        const bool is_escape = uri[i] == '%' && i + 2 < uri.size() &&
                               std::from_chars(code, code + 2, byte, 16).ptr == code + 2;
        if (is_escape && byte == 0)
            return {};  // no path contains a zero byte
        path += is_escape ? static_cast<char>(byte) : uri[i];
        i += is_escape ? 2 : 0;
    }
    return path;
}

std::string percent_encoded(const std::string& path) {
    std::string encoded;
    for (const char letter : path)
        if (std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
            std::strchr("-_.!~*'()/", letter))
            encoded += letter;
        else
            encoded += fmt::format("%{:02X}", static_cast<unsigned char>(letter));
    return encoded;
}
