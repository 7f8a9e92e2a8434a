#pragma once

#include "model/look/extent.h"
#include "model/look/look.h"

#include <optional>

/// The sizes that a look's targets depend on, px.
struct PictureSizes {
    Extent viewport;
    Extent source;
};

/// Small sizes for which drivers see the same kinds of targets as for `whole`: the same sides of
/// the same passes are powers of two. If none are near, this holds only for the viewport.
PictureSizes small_equivalent(const Look& look, const PictureSizes& whole);
/// The same for about a quarter of the size; nullopt: none is near, or a side would be below 128
/// px.
std::optional<PictureSizes> quarter_equivalent(const Look& look, const PictureSizes& whole);
