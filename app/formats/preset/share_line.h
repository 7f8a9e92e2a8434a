#pragma once

#include "base/diagnostic.h"
#include "model/preset/preset.h"

#include <string>
#include <string_view>

/// The preset as one line of text for chats and links: "afterglow:1:" and the base64url of its
/// compressed JSON. Contains only the preset's values; see with_all_values().
std::string share_line(const Preset& preset, const Look* look = nullptr);

/// Whether a text looks like a share line.
bool is_share_line(std::string_view text);

/// Parses a share line; ignores spaces and line breaks added by a chat. Errors have no file.
Result<Preset> parse_share_line(std::string_view text);
