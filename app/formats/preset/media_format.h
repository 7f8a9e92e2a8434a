#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// A sound or picture of the person's that was opened once.
struct MediaEntry {
    std::filesystem::path file;  // absolute
    std::string digest;          // file_digest() at that time
    std::string stamp;           // size and time of change then; the digest holds while they do

    bool operator==(const MediaEntry&) const = default;
};

/// The list of what was opened lately, the latest first.
std::string media_to_json(const std::vector<MediaEntry>& entries);
Result<std::vector<MediaEntry>> parse_media(std::string_view text,
                                            const std::filesystem::path& file);
