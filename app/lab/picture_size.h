#pragma once

#include "model/placing.h"

#include <optional>

/// The picture's size, chosen apart from the window.
struct PictureSize {
    bool follows_view = true;
    Extent fixed{1280, 720};
    double scale = 1.0;                             // 1/4 .. 2, of either
    std::optional<ViewShape> shape = std::nullopt;  // that follows the view; none: as the look
                                                    // has it

    bool operator==(const PictureSize&) const = default;
    /// `shaped_view`: what it is where it follows the view.
    Extent extent(Extent shaped_view) const;
    /// None: it is as small as it can be.
    std::optional<PictureSize> halved() const;
};

/// The nearest size whose scale is allowed.
PictureSize within_bounds(PictureSize size);
