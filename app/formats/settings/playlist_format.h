#pragma once

#include "base/diagnostic.h"
#include "model/tuning/playlist.h"

#include <string>
#include <string_view>

/// A playlist as JSON, with "format": "afterglow-playlist".
std::string playlist_to_json(const Playlist& playlist);
/// Errors, each with its line: unknown keys, numbers beyond their limits, more than 1000 presets.
Result<Playlist> parse_playlist(std::string_view text, const std::filesystem::path& file);
