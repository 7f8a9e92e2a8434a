#pragma once

#include "model/look/extent.h"
#include "model/picture/film_rate.h"

#include <cstdint>
#include <span>
#include <string>

// YUV4MPEG2, the form in which programs hand films to one another through pipes: 8 bits, 4:4:4, so
// that no pixel is mixed with its neighbours, by the matrix of ITU-R BT.709 in its limited range
// (Y 16..235, Cb and Cr 16..240).

/// What comes before the first frame. The form has no word for the matrix.
std::string y4m_header(Extent extent, const FilmRate& rate);

/// A frame of display_bytes(), each number rounded to the nearest.
std::string y4m_frame(Extent extent, std::span<const std::uint8_t> rgb);
