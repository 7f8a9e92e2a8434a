#pragma once

#include "model/picture/placing.h"

#include <optional>

/// The size of the picture, independent of the window.
struct PictureSize {
    bool follows_view = false;
    Extent fixed;        // if it does not follow the view; empty: follows until one is chosen
    double scale = 1.0;  // 1/4 to 2, of the view or of `fixed`
    std::optional<ViewShape> shape = std::nullopt;  // if has_shape(); nullopt: the look's
    bool fits_shape = false;  // the picture is the largest of its shape within `fixed`

    bool operator==(const PictureSize&) const = default;
    bool is_to_be_chosen() const { return !follows_view && fixed.is_empty(); }
    bool is_exactly(Extent extent) const { return !has_shape() && fixed == extent; }
    /// Whether the picture is the largest with a shape in its room, instead of filling it.
    bool has_shape() const { return follows_view || fixed.is_empty() || fits_shape; }
    /// The size that the picture is fitted into before scaling, px.
    Extent room(Extent view) const { return has_view_room() ? view : fixed; }
    Extent scaled(Extent extent) const;
    /// nullopt if the scale would be too small.
    std::optional<PictureSize> halved() const;

private:
    bool has_view_room() const { return follows_view || fixed.is_empty(); }
};

/// Fixed at the size that fits into the view now, with one screen pixel per pixel. The scale stays.
PictureSize fixed_in(const PictureSize& size, Extent view);

/// The nearest size whose scale is allowed.
PictureSize within_bounds(PictureSize size);
