#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Base64 without padding, safe for links and chats (RFC 4648, section 5).
std::string base64url_encode(std::string_view bytes);

/// nullopt for invalid text; padding is allowed.
std::optional<std::string> base64url_decode(std::string_view text);
