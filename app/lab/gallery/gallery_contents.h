#pragma once

#include "lab/library/library.h"
#include "lab/offline/prepared_look.h"

#include <filesystem>
#include <string>
#include <vector>

/// A look without a preset, or with one.
struct GalleryItem {
    PreparedLook prepared;
    std::filesystem::path file;  // of the preset; "": the look itself, or `line`
    std::string line;            // a preset given as a line of text
    std::string name;            // of the preset: its own, otherwise that of its file
    std::string stem;            // file name in the gallery without extension; unique
};

/// A look or stack with its presets.
struct GalleryGroup {
    Look look;
    std::vector<GalleryItem> items;
};

/// The groups of looks, stacks, presets and shaders of other programs, in this order; none: all
/// looks and stacks of the library. A preset adds only itself. Looks and presets with errors are
/// left out and added to `problems`. Fails if nothing is left.
Result<std::vector<GalleryGroup>> gallery_contents(const std::vector<std::string>& arguments,
                                                   const Library& library, Diagnostics& problems);
