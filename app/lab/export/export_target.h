#pragma once

#include "lab/offline/prepared_look.h"

#include <filesystem>
#include <string>
#include <vector>

/// What an export wrote.
struct ExportedLook {
    std::filesystem::path path;
    std::size_t files = 0;
    std::uintmax_t bytes = 0;
};

/// What to export: a look with its values and content, drawn at a size.
struct ExportRequest {
    const PreparedLook& prepared;
    Extent size;
    std::filesystem::path path;
};

/// A format for using a look in another program: one row of export_targets().
struct ExportTarget {
    std::string name;  // "portable"
    std::string help;  // what it writes: "a folder with ..."
    /// What would be lost, a sentence per item; empty: nothing.
    std::vector<std::string> (*losses)(const PreparedLook& prepared);
    /// Writes all or nothing. Errors name the file.
    Result<ExportedLook> (*write)(const ExportRequest& request);
};
const std::vector<ExportTarget>& export_targets();

/// Fails with the names of all targets.
Result<const ExportTarget*> find_export_target(const std::string& name);
