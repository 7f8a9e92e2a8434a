#pragma once

#include "formats/isf/header.h"
#include "model/look/look.h"

#include <string>

/// An ISF shader's own texts.
struct IsfSource {
    std::filesystem::path file;
    std::string text;                   // with its header
    std::filesystem::path vertex_file;  // "": it has none
    std::string vertex_text;
};

/// The stages of one pass as GLSL 4.10: what the format gives a shader, then the author's lines.
/// The pass's number is a constant, so that what other passes do counts for nothing.
Stage isf_fragment_stage(const IsfSource& source, const IsfHeader& header, std::size_t pass);
Stage isf_vertex_stage(const IsfSource& source, const IsfHeader& header, std::size_t pass);

/// The fragment stage that draws the picture `image` over the whole target; with the vertex stage
/// of a shader that has none of its own.
Stage isf_stretching_stage();
