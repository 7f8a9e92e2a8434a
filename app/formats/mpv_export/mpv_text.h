#pragma once

#include "model/look/look.h"

#include <string>
#include <string_view>
#include <vector>

/// The prefix of all names that an export adds. renamed_built_ins() renames the author's.
inline constexpr const char* mpv_prefix = "afterglow_";

/// The text without "//!", which would start a block even inside a comment.
std::string without_mpv_marks(std::string_view text);

/// A block of an mpv user shader: one draw.
struct MpvBlock {
    std::string about;               // for users, in messages and statistics of mpv
    std::vector<std::string> binds;  // further textures that it reads, besides HOOKED
    std::string save;                // the texture that it writes; "": the picture
    std::string width;               // expressions in reverse Polish notation
    std::string height;
    std::string values;  // `#define` lines of the parameters that it reads
    std::string body;    // GLSL with `vec4 hook()`
};

std::string mpv_block_text(const MpvBlock& block);

/// A side of a target as an expression for WIDTH or HEIGHT.
std::string mpv_side(const Side& side, std::size_t axis);
/// The size of a target in GLSL, from `afterglow_output` and `afterglow_source`.
std::string mpv_size(const Pass& pass);

/// Words that mean something else where mpv inserts a shader.
std::vector<std::string> mpv_reserved_words();

/// The GLSL expression for what a target of this format keeps of `color`, which is an expression.
std::string mpv_stored(Format format, const std::string& color);
