#pragma once

#include "lab/library/library.h"

#include <string>
#include <vector>

/// A listed look, preset, signal or pattern.
struct CatalogEntry {
    std::string id;    // for the command line
    std::string name;  // for display
    std::string about;
    std::string look;  // of presets
    std::filesystem::path file;

    bool operator==(const CatalogEntry&) const = default;
};

/// All looks. An unreadable one is listed with its error as `about`.
std::vector<CatalogEntry> list_looks(const Library& library);
std::vector<CatalogEntry> list_presets(const Library& library);
/// All signals, with their settings and defaults in `about`.
std::vector<CatalogEntry> list_signals();
std::vector<CatalogEntry> list_patterns();
