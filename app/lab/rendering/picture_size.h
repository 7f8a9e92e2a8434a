#pragma once

#include "model/picture/placing.h"

#include <optional>

/// The picture's size, chosen apart from the window.
struct PictureSize {
    bool follows_view = false;
    Extent fixed;        // where it does not follow the view; empty: follows until one is chosen
    double scale = 1.0;  // 1/4 .. 2, of either
    std::optional<ViewShape> shape = std::nullopt;  // of a size that has_shape(); none: the look's
    bool fits_shape = false;  // the picture is the largest of its shape within `fixed`

    bool operator==(const PictureSize&) const = default;
    bool is_to_be_chosen() const { return !follows_view && fixed.is_empty(); }
    bool is_exactly(Extent extent) const { return !has_shape() && fixed == extent; }
    /// Whether the picture is the largest of a shape within its room, rather than all of it.
    bool has_shape() const { return follows_view || fixed.is_empty() || fits_shape; }
    /// What the picture is fitted into, before it is scaled, px.
    Extent room(Extent view) const { return has_view_room() ? view : fixed; }
    Extent scaled(Extent extent) const;
    /// None: it is as small as it can be.
    std::optional<PictureSize> halved() const;

private:
    bool has_view_room() const { return follows_view || fixed.is_empty(); }
};

/// Fixed at what fits into the view now, at one pixel of the screen a pixel; the scale stays.
PictureSize fixed_in(const PictureSize& size, Extent view);

/// The nearest size whose scale is allowed.
PictureSize within_bounds(PictureSize size);
