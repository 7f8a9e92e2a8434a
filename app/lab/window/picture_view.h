#pragma once

#include "model/look/extent.h"

#include <array>

/// The position of a picture in its view. The zoom is in device pixels per pixel of the picture.
struct PictureView {
    enum class Fit {
        integer,  // the largest integer zoom that fits, or `whole` if 1 does not fit
        whole,    // all of the picture
        free,     // `zoom`
    };

    Fit fit = Fit::integer;
    double zoom = 1.0;  // if free
    double x = 0.5;     // centre of the view, 0 left to 1 right
    double y = 0.5;     // 0 top to 1 bottom

    bool operator==(const PictureView&) const = default;
    /// The effective zoom of a picture in a view, both in device pixels.
    double zoom_for(Extent picture, Extent view) const;
    /// Sets the zoom to `next` and keeps the point (at_x, at_y) of the picture, 0..1, in place.
    void zoom_about(double at_x, double at_y, double current, double next);
};

/// The next zoom in (or out): 1/8 1/4 1/2 1 2 3 4 6 8 12 16 24 32 48 64 96 128.
double next_zoom(double zoom, bool is_in);

/// The position of a picture in a view, in device pixels from the top left.
struct PicturePosition {
    double left = 0.0;  // of the picture in the view; negative: cropped
    double top = 0.0;
    double zoom = 1.0;

    /// The pixel of the picture at a point of the view.
    std::array<double, 2> pixel_at(double x, double y) const {
        return {(x - left) / zoom, (y - top) / zoom};
    }
};
/// The corner of the picture is at a whole pixel of the view, so that 1:1 is exact.
PicturePosition position_of(const PictureView& view, Extent picture, Extent size);

/// The position of a wipe line, in device pixels from the left of the view. `share` is relative to
/// the visible part of the picture.
int wipe_column(const PicturePosition& position, Extent picture, Extent size, double share);
/// The share at a position of the line.
double wipe_share(const PicturePosition& position, Extent picture, Extent size, double column);
