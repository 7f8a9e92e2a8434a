#pragma once

#include "formats/look/loaded_look.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// A format of another program whose files open as looks. A new format is one folder and one row.
struct ForeignFormat {
    std::string_view label;                        // "Shadertoy"; "" for a further row of a format
    std::span<const std::string_view> extensions;  // lower case: files that may have the format
    bool (*is_file)(const std::filesystem::path& file);  // by its name and content
    LoadedLook (*load)(const std::filesystem::path& file, const IncludeFolders& includes,
                       const LoadOptions& help);
};

/// The first format that recognises a file; null: it is not a look of another program.
const ForeignFormat* find_foreign_format(const std::filesystem::path& file);
/// Extensions of all formats, each once.
std::vector<std::string> foreign_extensions();
/// "RetroArch .slangp and .slang, ISF, Shadertoy, plain fragment shaders".
std::string foreign_labels();
