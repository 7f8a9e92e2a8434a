#pragma once

#include "model/look/look.h"

/// How a conversion reads its picture.
enum class Copied {
    texel_by_texel,  // both have the same size
    whole,           // stretched, with the filter of the input
    upside_down,     // as `whole`, with the first row last
};

/// A fragment shader that copies the picture `image` in another encoding. Values below 0 and above
/// 1 use the same curve, as when a source picture is read (IEC 61966-2-1).
Stage conversion_stage(Encoding from, Encoding to, Copied how = Copied::texel_by_texel);
