#pragma once

#include "base/diagnostic.h"
#include "model/preset/preset.h"

#include <string>
#include <string_view>

/// The preset as one line of text for chats and links: "afterglow:1:" and the base64url of its
/// compressed JSON. It holds the values that the preset holds; see with_all_values().
std::string share_line(const Preset& preset, const Look* look = nullptr);

/// Whether a text is meant to be a share line.
bool is_share_line(std::string_view text);

/// Reads a share line; blanks and line breaks that a chat put in are dropped. Errors carry no file.
Result<Preset> parse_share_line(std::string_view text);
