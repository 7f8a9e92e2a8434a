#pragma once

#include "formats/effect/effect_uniforms.h"
#include "formats/mpv_export/mpv_parameters.h"
#include "formats/mpv_export/mpv_textures.h"

#include <set>
#include <string>

/// What the blocks of all passes share.
struct MpvContext {
    const Look& look;    // the reduced look
    const Look& author;  // whose files are read
    const MpvParameters& parameters;
    const MpvTextures& textures;
    std::size_t blocks = 0;  // of the whole file that draw
};

/// The block of a pass, and the parameters that it reads.
struct MpvPass {
    MpvBlock block;  // without values
    std::set<std::string> parameters;
};

/// Writes the block of a pass: the values of its uniforms, the author's text with all its includes
/// in place, and `hook()`. The error is the reason why mpv can't draw it.
Result<MpvPass> mpv_pass(std::size_t pass, const EffectUniforms& uniforms,
                         const MpvContext& context);
