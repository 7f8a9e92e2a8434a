#pragma once

#include "model/look/extent.h"
#include "model/look/look.h"

#include <optional>

/// What the sizes of a look's targets follow from, px.
struct PictureSizes {
    Extent viewport;
    Extent source;
};

/// Small sizes with which drivers see the same kinds of targets as with `whole`: sides that are
/// powers of two, and sides that are not, of the same passes. Where there are none near, of the
/// viewport at least.
PictureSizes small_like(const Look& look, const PictureSizes& whole);
/// The same of about a quarter; none: there is none near, or it would be a few pixels.
std::optional<PictureSizes> quarter_like(const Look& look, const PictureSizes& whole);
