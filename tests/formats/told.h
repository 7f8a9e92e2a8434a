#pragma once

#include "base/diagnostic.h"
#include "base/text.h"

#include <filesystem>
#include <string>

/// "a.fs:2: error: ...", one per line, with paths relative to `folder`.
inline std::string told_in(const std::filesystem::path& folder, const Diagnostics& diagnostics) {
    std::string text = to_string(diagnostics);
    const std::string start = folder.string() + "/";
    for (std::size_t at = text.find(start); at != text.npos; at = text.find(start))
        text.erase(at, start.size());
    return std::string(trim(text));
}
