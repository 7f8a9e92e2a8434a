#pragma once

#include "lab/files/folder_listing.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// A typed name or path, divided after its last '/'.
struct TypedPath {
    std::filesystem::path folder;  // absolute, normalised
    std::string name;              // the rest; "": the folder itself

    std::filesystem::path file() const { return name.empty() ? folder : folder / name; }
    bool operator==(const TypedPath&) const = default;
};

/// Resolves a typed text against a folder. "~" and "~/" are the home folder, "." and ".." are
/// folders. Pasted texts also work: quoted paths, and "file:" URIs with escapes.
TypedPath parse_typed_path(std::string_view text, const std::filesystem::path& folder,
                           const std::filesystem::path& home);

/// The text after the Tab key: the name is extended as far as all rows agree that begin with it,
/// ignoring case. A complete folder ends with '/'. If nothing can be added, the first of them is
/// taken, otherwise the first row that contains the name. Unchanged if there is none.
std::string completed_path(const std::string& text, const std::vector<FolderEntry>& rows);

/// The user's home folder: $HOME, otherwise "/".
std::filesystem::path home_folder();
