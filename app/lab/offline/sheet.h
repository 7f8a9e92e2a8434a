#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <string>
#include <vector>

/// A picture of a contact sheet and its caption.
struct SheetCell {
    std::string caption;
    Picture picture;
};

/// Fails if a sheet of `count` pictures of this size in `columns` columns would exceed the size
/// limit. Call it before drawing them.
Result<void> check_sheet(Extent picture, int count, int columns);

/// The pictures in rows of `columns`, with captions below; RGB, display-encoded. Linear pictures
/// are clamped and sRGB-encoded. All pictures have the same size. Fails if the sheet exceeds the
/// size limit, or without a font.
Result<Picture> sheet_of(const std::vector<SheetCell>& cells, int columns);
