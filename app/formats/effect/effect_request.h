#pragma once

#include "formats/portable/exact_picture.h"
#include "formats/portable/portable_json.h"
#include "model/look/look.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A look to write in the format of another program.
struct EffectRequest {
    const Look& look;
    const Values& values;
    Extent size;       // of the picture, px
    Extent source;     // of the source picture, px
    std::string name;  // of the main file, without its ending
    const SourceNotices& notices;
    bool has_live_parameters = false;   // not constants, in a format that has both
    std::filesystem::path folder = {};  // of the main file, absolute
    std::optional<Spec> signal = {};    // complete, for a beam
};

/// What was written, all paths relative to the folder of the main file.
struct EffectOutput {
    std::map<std::string, std::string> texts;     // by path
    std::map<std::string, PictureFile> pictures;  // generated, by path
    std::vector<std::string> losses;              // a sentence per item
};

/// The head of an exported file: the look, and author and licence of each source file. `mark`: what
/// starts a comment line.
std::string notice_comment(const Look& look, const SourceNotices& notices,
                           std::string_view mark = "//");
