#pragma once

#include "formats/pack/pack_format.h"
#include "lab/library/library.h"
#include "model/look/look.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// A look and its files for a pack.
struct LookFiles {
    PackedLook look;
    std::map<std::string, std::filesystem::path> files;  // by path in the pack
    std::vector<PackedSource> sources;
};

/// The files of a look: its folder without hidden files, links and backup copies, and includes of
/// the user. A look of another program brings all files that it reads, in their places relative to
/// each other. Fails if the look reads files elsewhere.
Result<LookFiles> files_of_look(const Look& look, const Library& library);
