#pragma once

#include "lab/files/folder_listing.h"

#include <string>
#include <string_view>
#include <vector>

/// How the rows of a folder are sorted.
struct FileOrder {
    enum class Key { name, size, modified };

    Key key = Key::name;
    bool is_descending = false;

    bool operator==(const FileOrder&) const = default;
};

/// Which entries of a folder are listed, and in which order.
struct FileFilter {
    std::string typed = {};  // part of a name; "": all
    FileOrder order = {};
    bool shows_hidden = false;

    bool operator==(const FileFilter&) const = default;
};

/// The listed entries. A name that is the typed text, perhaps with an extension, comes first. Then
/// come names that begin with it, then names that contain it, ignoring case. In each group, folders
/// come first. Numbers in names are compared by value. Hidden entries are listed if they are
/// wanted, or if the typed text begins with a dot.
std::vector<FolderEntry> file_rows(const FolderListing& listing, const FileFilter& filter);

/// Whether a name comes before another: without case, numbers by value ("frame 2", "frame 10").
bool is_name_before(std::string_view one, std::string_view other);

/// "318 B", "4.2 KB", "1.5 GB": powers of 1000.
std::string file_size_text(std::uintmax_t bytes);

/// "2026-11-26 14:05" in the user's time zone; "": unknown.
std::string modified_text(std::int64_t seconds);
