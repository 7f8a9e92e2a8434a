#pragma once

#include "formats/isf/header.h"
#include "model/look/look.h"

#include <string>

/// The texts of an ISF shader.
struct IsfSource {
    std::filesystem::path file;
    std::string text;                   // including its header
    std::filesystem::path vertex_file;  // "": no vertex shader
    std::string vertex_text;
};

/// The stages of one pass as GLSL 4.10: the declarations of the format, then the author's lines.
/// The pass's number is a constant, so that the code of other passes is dead code.
Stage isf_fragment_stage(const IsfSource& source, const IsfHeader& header, std::size_t pass);
Stage isf_vertex_stage(const IsfSource& source, const IsfHeader& header, std::size_t pass);

/// The fragment stage that draws the picture `image` over the whole target. Used with the default
/// vertex stage.
Stage isf_stretching_stage();
