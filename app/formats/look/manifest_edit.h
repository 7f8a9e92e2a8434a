#pragma once

#include "base/diagnostic.h"
#include "model/plan/plan.h"

#include <filesystem>
#include <string>
#include <string_view>

/// The text of a look.json with the overridden formats, scales and filters of passes; all other
/// bytes are unchanged. A filter is written to every input that reads the pass. Errors name `file`.
Result<std::string> with_overrides_written(std::string_view text, const PassOverrides& overrides,
                                           const std::filesystem::path& file);

/// The content of a look.json.
struct ManifestText {
    std::string mark;  // its byte order mark, or ""
    std::string text;  // the bytes after the mark

    std::string bytes() const { return mark + text; }
};

/// Reads a look.json to edit it. Fails for a link to a file outside the look's folder.
Result<ManifestText> read_manifest(const std::filesystem::path& manifest);

/// Applies it to the file atomically.
Result<void> write_overrides(const std::filesystem::path& manifest, const PassOverrides& overrides);
