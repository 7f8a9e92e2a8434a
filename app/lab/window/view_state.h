#pragma once

#include "lab/window/pass_view.h"
#include "lab/window/source_search.h"
#include "lab/window/timeline_view.h"

/// Sizes of the picture views in device pixels.
struct ViewSizes {
    Extent picture;
    Extent inspector;
    Extent output;  // empty while closed
    Extent cell;    // size of a texel that fits its numbers
    int thumbnail_height = 0;
};

/// Requested fits that wait for a measurement.
struct PendingFits {
    bool levels = false;  // black and white of the inspected texture
    bool gain = false;    // gain of the displayed difference

    bool operator==(const PendingFits&) const = default;
    bool is_any() const { return levels || gain; }
};

/// What the views of the picture and of the inspected pass display.
struct ViewState {
    PictureView picture;
    PassView inspected;
    bool shows_pass_large = false;  // the inspected pass instead of the picture
    double wipe_share = 0.5;        // position of the wipe line in the picture
    PendingFits pending;
    SourceSearch source;  // in the compiled source
    ViewSizes sizes;
    TimelineView timeline;

    /// The view of the picture, or of the pass that replaces it.
    PictureView& large() { return shows_pass_large ? inspected.view : picture; }
    const PictureView& large() const { return shows_pass_large ? inspected.view : picture; }
};
