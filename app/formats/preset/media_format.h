#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// A recently opened sound or picture of the user.
struct MediaEntry {
    std::filesystem::path file;  // absolute
    std::string digest;          // file_digest() when opened
    std::string stamp;           // size and modification time when opened; the digest is valid
                                 // while they match

    bool operator==(const MediaEntry&) const = default;
};

/// The recently opened media, latest first.
std::string media_to_json(const std::vector<MediaEntry>& entries);
Result<std::vector<MediaEntry>> parse_media(std::string_view text,
                                            const std::filesystem::path& file);
