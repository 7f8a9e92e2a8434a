#pragma once

#include "lab/document/document.h"
#include "lab/media/media_input.h"
#include "lab/rendering/picture_size.h"

#include <optional>

/// The render size of the open look, px. It depends on the user's choice, the view and the aspect
/// ratio of the source.
class RenderSize {
public:
    RenderSize(const OpenDocument& document, const MediaInput& media)
        : m_document(document), m_media(media) {}

    const PictureSize& chosen() const { return m_chosen; }
    void choose(const PictureSize& size) { m_chosen = within_bounds(size); }
    Extent extent() const;
    /// The shape of a picture with has_shape(). Foreign looks keep the aspect ratio of their source
    /// by default; native looks fill the view.
    ViewShape shape() const;

    /// The size of the pane that shows the picture, px. `is_overlay`: of the window under an
    /// overlay; the picture then has this size instead of the chosen one.
    void set_view(Extent view_pixels, bool is_overlay = false);
    /// Fixes the size to the current view.
    void fix_to_view();
    /// Fixes a size that is still undecided when the view has been unchanged for 0.5 s. The panes
    /// of a new window need some frames to reach their size.
    void update(double wall_seconds);

private:
    const OpenDocument& m_document;
    const MediaInput& m_media;
    PictureSize m_chosen;
    Extent m_view{1280, 720};
    bool m_is_overlay = false;
    std::optional<double> m_view_seconds;  // since it changed; nullopt: not set yet
};
