#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <string>
#include <vector>

/// One picture of a contact sheet and what it is called.
struct SheetCell {
    std::string caption;
    Picture picture;
};

/// Whether a sheet of so many pictures of one size is no larger than a picture may be; `columns`
/// stand side by side. To be asked before they are drawn.
Result<void> check_sheet(Extent picture, int count, int columns);

/// The pictures in rows of `columns`, each with its caption below; RGB, display-encoded. Linear
/// pictures are clamped and sRGB-encoded. All pictures are of one size. Fails where the sheet would
/// be larger than a picture may be, or there is no font.
Result<Picture> sheet_of(const std::vector<SheetCell>& cells, int columns);
