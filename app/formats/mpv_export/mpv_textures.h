#pragma once

#include "base/diagnostic.h"
#include "formats/mpv_export/mpv_text.h"
#include "model/look/look.h"

#include <map>
#include <string>
#include <vector>

/// The textures of a look in mpv: saved targets, their mip levels, and pictures. mpv reads all of
/// them with a linear filter and clamped at the edge, and has no mip levels.
class MpvTextures {
public:
    /// `look` lives as long as this.
    explicit MpvTextures(const Look& look);

    /// Why a pass can't be drawn, as a sentence; "" if all can.
    std::string obstacle() const;

    /// The name for SAVE of a pass.
    static std::string name_of(const Pass& pass);
    /// The name for BIND of what an input reads.
    std::string name_of(const Input& input) const;
    /// The sampler of that in GLSL.
    std::string sampler_of(const Input& input) const;
    /// The number of mip levels that an input reads besides the first.
    int levels_of(const Input& input) const { return input.sampler.mipmap ? m_levels : 0; }
    /// The name of a level, from 1. 0 is the texture itself.
    std::string level_name(const Input& input, int level) const;
    /// All textures that a pass reads.
    std::vector<std::string> binds_of(const Pass& pass) const;
    /// Whether the texels are 8-bit numbers, which 16-bit floats only approximate.
    bool is_bytes(const Input& input) const;

    /// The blocks that draw the mip levels of what a pass reads, each once.
    std::vector<MpvBlock> level_blocks(const Pass& pass);
    /// The blocks with the pictures of the look.
    Result<std::string> picture_blocks();

private:
    void limit_levels();
    const Pass* pass_of(const Input& input) const;
    std::vector<MpvBlock> levels(const Input& input) const;
    std::string level_side(const Input& input, int level, char axis) const;

    const Look& m_look;
    int m_levels;
    std::map<std::string, Extent> m_extents;  // of pictures
    std::vector<std::string> m_drawn;         // textures that have their mip levels
};
