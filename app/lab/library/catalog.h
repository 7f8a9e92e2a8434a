#pragma once

#include "lab/library/library.h"

#include <string>
#include <vector>

/// One line of what there is to choose from.
struct CatalogEntry {
    std::string id;    // what the command line takes
    std::string name;  // what a person reads
    std::string about;
    std::string look;  // of presets
    std::filesystem::path file;

    bool operator==(const CatalogEntry&) const = default;
};

/// Looks with their names; one that cannot be read is listed with the reason as its `about`.
std::vector<CatalogEntry> list_looks(const Library& library);
std::vector<CatalogEntry> list_presets(const Library& library);
/// Each with its settings and their defaults in `about`.
std::vector<CatalogEntry> list_signals();
std::vector<CatalogEntry> list_patterns();
