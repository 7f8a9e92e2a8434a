#pragma once

#include "lab/window/picture_view.h"
#include "model/look/texture_choice.h"
#include "model/picture/channels.h"
#include "model/picture/levels.h"

#include <optional>
#include <string>

/// The inspected texture and its display settings.
struct PassView {
    std::string pass;                    // the selected pass; "": not selected
    std::optional<TextureChoice> other;  // instead of its current picture
    Levels levels;                       // stored values that are displayed as black and white
    double exposure = 0.0;               // stops, relative to black
    Channels channels = Channels::color;
    bool marks_flaws = false;  // marks non-finite and negative values
    bool marks_clipping = false;
    bool is_false_color = false;
    PictureView view{PictureView::Fit::whole};

    bool operator==(const PassView&) const = default;
    /// Inspects the current picture of a pass.
    void inspect(const std::string& name);
    /// Inspects any texture; that of a pass also selects the pass.
    void inspect(const TextureChoice& choice);
    /// The name of the inspected texture: "persistence", "noise mip 2".
    std::string label() const { return other ? other->label() : pass; }
    /// Fits black and white to the range of all finite values.
    void fit(const Statistics& statistics);
    /// Resets levels and exposure.
    void reset_levels();
    bool has_levels() const { return levels != Levels{} || exposure != 0.0; }
};
