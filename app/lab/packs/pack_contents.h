#pragma once

#include "formats/pack/pack_format.h"
#include "lab/library/library.h"
#include "model/look/look.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// What a pack will contain.
struct PackContents {
    PackManifest manifest;
    std::map<std::string, std::filesystem::path> files;  // by path in the pack
    std::map<std::string, std::string> texts;            // presets; they name the copies of files
    std::map<std::string, Look> looks;                   // looks and stacks by id, for thumbnails
    std::vector<std::filesystem::path> preset_files;     // of the manifest's presets; "": a line
};

/// Collects looks, the looks of stacks, all presets of each, and the files of these presets. A
/// preset adds its look and only itself. Fails for looks with errors, for files that a look reads
/// outside its folder, and for missing files of presets; each error says which.
Result<PackContents> pack_contents(const std::vector<std::string>& arguments,
                                   const std::string& name, const Library& library);
