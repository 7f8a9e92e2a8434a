#pragma once

#include "model/look/extent.h"
#include "model/picture/frame_rate_fraction.h"

#include <cstdint>
#include <span>
#include <string>

// YUV4MPEG2, a format for piping films between programs: 8 bits, 4:4:4, so without chroma
// subsampling. Uses the matrix of ITU-R BT.709 in limited range (Y 16..235, Cb and Cr 16..240).

/// The header before the first frame. The format can't declare the matrix.
std::string y4m_header(Extent extent, const FrameRateFraction& rate);

/// A frame of display_bytes(), rounded to the nearest codes.
std::string y4m_frame(Extent extent, std::span<const std::uint8_t> rgb);
