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
    bool has_stages = false;      // also other shader languages, if the target has them
    bool has_parameters = false;  // parameters of mpv instead of `#define` lines
};

/// A format for using a look in another program: one row of export_targets().
struct ExportTarget {
    std::string name;                // "portable"
    std::string label;               // in the window: "Web page"
    std::string extension;           // ".html"; "" for a folder
    std::string help;                // what it writes: "a folder with ..."
    std::vector<std::string> keeps;  // what it can carry, a phrase per item
    bool has_subframes = false;      // false: it draws whole frames
    /// What this format loses, see losses_of().
    Result<std::vector<std::string>> (*losses)(const PreparedLook& prepared);
    /// Writes all or nothing. Errors name the file.
    Result<ExportedLook> (*write)(const ExportRequest& request);
    /// Opens the written files again, and compiles and compares their contents.
    Result<void> (*check)(const ExportRequest& request);
    /// A web page that draws what was written. It may be in `folder`. Null: verify_export() opens
    /// the written file as a look.
    Result<std::filesystem::path> (*page)(const ExportRequest& request,
                                          const std::filesystem::path& folder);
    std::string why_not_drawn = {};  // by verify_export(); "": it can draw it
};
const std::vector<ExportTarget>& export_targets();

/// Fails with the names of all targets.
Result<const ExportTarget*> find_export_target(const std::string& name);

/// What would be lost, a sentence per item; empty: nothing. The error is the reason why the look
/// can't be exported.
Result<std::vector<std::string>> losses_of(const ExportTarget& target,
                                           const PreparedLook& prepared);

/// Writes and checks.
Result<ExportedLook> export_look(const ExportTarget& target, const ExportRequest& request);
