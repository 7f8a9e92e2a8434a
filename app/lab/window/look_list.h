#pragma once

#include "lab/library/library_view.h"

#include <string>
#include <string_view>
#include <vector>

/// The looks whose name, id or description has all search words, in the order of the library.
std::vector<const ListedLook*> matching_looks(const std::vector<ListedLook>& looks,
                                              std::string_view search);

/// A recently opened look.
struct RecentLook {
    std::string argument;  // opens it
    std::string name;
};

/// The looks that were opened last, without the open one, at most ten. `recent` has their
/// arguments, the latest first.
std::vector<RecentLook> recent_looks(const std::vector<std::string>& recent,
                                     const std::vector<ListedLook>& looks, const std::string& open);

/// The folder that may have a picture of the look. A stack has no folder of its own, so it is that
/// of its presets.
std::filesystem::path picture_folder(const ListedLook& look, const Roots& roots);
