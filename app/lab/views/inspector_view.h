#pragma once

#include "lab/inspect/texel_inspector.h"
#include "lab/views/displayed_texture.h"
#include "lab/views/view_image.h"

#include <memory>
#include <optional>

/// The view of the inspector: the inspected texture with its statistics and histogram.
class InspectorView {
public:
    /// Uses the view programs of another look; null: nothing is displayed.
    void set_context(std::shared_ptr<ContextViews> context);
    /// Selects the inspected texture, for this view and for the main view.
    void select(const Executor& executor, const WindowState& window, TexelInspector& texels);
    /// Draws and measures the selected texture while the inspector is open.
    void update(const Executor& executor, const WindowState& window, TexelInspector& texels,
                double seconds);

    /// Null: neither the inspector nor the main view displays one.
    const DisplayedTexture* selected() const { return m_selected ? &*m_selected : nullptr; }
    ViewImage image() const { return m_context ? image_of(m_context->inspected) : ViewImage{}; }
    /// The statistics of the inspected target; nullopt: the inspector is closed, or they are
    /// pending.
    std::optional<Statistics> statistics() const {
        return m_context ? m_context->inspection.statistics() : std::nullopt;
    }
    /// The histogram between the inspector's levels; empty: as for statistics().
    Histogram histogram() const {
        return m_context ? m_context->inspection.histogram() : Histogram{};
    }

private:
    std::shared_ptr<ContextViews> m_context;     // of the displayed look; null: not created
    std::optional<DisplayedTexture> m_selected;  // of this update
};

/// The display options for a target with this encoding.
ViewOptions options_for(const PassView& view, Encoding encoding);

/// The inspected pass; the last one if the chosen pass is empty or no longer exists.
int inspected_pass(const Look& look, const PassView& inspected);

/// The view of the inspector; fits everything while the main view is used for navigation.
PictureView inspector_view(const ViewState& views);
