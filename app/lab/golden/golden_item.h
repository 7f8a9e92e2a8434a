#pragma once

#include "lab/library/library.h"

#include <filesystem>
#include <string>
#include <vector>

/// A look or preset in a user's folder, and the name of its golden picture.
struct GoldenItem {
    std::string name;            // of the picture, without ".png"
    std::string look;            // id
    std::string preset;          // file name without .json; "": the look itself
    std::filesystem::path file;  // the look's folder, a shader of another program, or a preset
};

/// The looks and presets in a folder.
struct GoldenFolder {
    std::vector<GoldenItem> items;  // by name
    std::vector<LookEntry> looks;   // those that presets of the folder can name
};

/// Finds all looks (folders with look.json), looks of other programs and presets in a folder and
/// its subfolders, without hidden ones. Shaders in the folder of a look are parts of it. Names are
/// unique, also without regard to case: equal ones get the subfolder, then a digest of the path.
/// Fails if the folder contains none.
Result<GoldenFolder> read_golden_folder(const std::filesystem::path& folder);
