#pragma once

#include <optional>
#include <string>
#include <string_view>

/// RFC 4648, section 5: letters that survive in links and chats, without padding.
std::string base64url_encode(std::string_view bytes);

/// Nothing where the text is no such encoding; padding is allowed.
std::optional<std::string> base64url_decode(std::string_view text);
