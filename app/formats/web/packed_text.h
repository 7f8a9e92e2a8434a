#pragma once

#include <string>
#include <string_view>

/// The bytes in base64 (RFC 4648, section 4), with padding.
std::string base64(std::string_view bytes);

/// The bytes compressed with gzip (RFC 1952), in base64.
std::string gzip_base64(const std::string& bytes);
