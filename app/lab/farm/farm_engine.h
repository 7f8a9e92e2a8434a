#pragma once

#include "base/diagnostic.h"
#include "lab/farm/farm_work.h"

#include <filesystem>
#include <string>
#include <vector>

/// A file of the folder for a farm.
struct FarmFile {
    std::string name;  // relative to the folder
    std::string text;
    bool is_executable = false;

    bool operator==(const FarmFile&) const = default;
};

/// A program that runs jobs on several cores or machines: one row of farm_engines().
struct FarmEngine {
    std::string name;  // on the command line
    /// Its own files. `run` is one of them.
    std::vector<FarmFile> (*files)(const FarmWork& work);
};
const std::vector<FarmEngine>& farm_engines();

/// All files for an engine: `run` starts everything, `part NUMBER` draws one part, and `join` makes
/// one file of all pictures, if the work has it.
std::vector<FarmFile> farm_files(const FarmWork& work, const FarmEngine& engine);

/// Writes the files into `folder`, and makes the folders "frames" and "logs". Fails if the folder
/// exists and is not empty: pictures of another film would count as finished.
Result<void> write_farm_folder(const std::filesystem::path& folder, const FarmWork& work,
                               const FarmEngine& engine);
