#pragma once

#include "lab/document/document.h"
#include "lab/media/drive.h"
#include "lab/rendering/picture_size.h"

#include <optional>

/// The size that the open look is drawn in, px: what the user chose, in the view and with the shape
/// of the source.
class RenderSize {
public:
    RenderSize(const OpenDocument& document, const Drive& drive)
        : m_document(document), m_drive(drive) {}

    const PictureSize& chosen() const { return m_chosen; }
    void choose(const PictureSize& size) { m_chosen = within_bounds(size); }
    Extent extent() const;
    /// The shape of a picture whose size has_shape(). Looks of other programs keep the shape of
    /// their source unless the user chose otherwise; our own fill the view.
    ViewShape shape() const;

    /// The size of the pane that shows the picture, px.
    void set_view(Extent view_pixels);
    /// Fixes the size at what fits into the view now.
    void fix_to_view();
    /// Fixes a size that is still to be chosen once the view has kept its size for half a second:
    /// the panes of a new window reach theirs after some frames only.
    void update(double wall_seconds);

private:
    const OpenDocument& m_document;
    const Drive& m_drive;
    PictureSize m_chosen;
    Extent m_view{1280, 720};
    std::optional<double> m_view_seconds;  // since it changed; nullopt: not set yet
};
