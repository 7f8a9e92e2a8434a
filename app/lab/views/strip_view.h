#pragma once

#include "lab/inspect/context_views.h"
#include "lab/inspect/thumbnails.h"
#include "lab/views/view_image.h"

#include <memory>

/// The strip of passes: a thumbnail and the level of each pass.
class StripView {
public:
    /// Uses the view programs of another look; null: nothing is displayed.
    void set_context(std::shared_ptr<ContextViews> context);
    /// `height` of the thumbnails in device pixels; 0: the strip is hidden.
    void update(const Executor& executor, const Values& values, int height, double seconds);

    ViewImage thumbnail(std::size_t pass) const { return image_of(m_thumbnails.picture(pass)); }
    bool is_stale(std::size_t pass) const { return m_thumbnails.is_stale(pass); }
    /// The level of a pass; null: not measured.
    const TargetLevel* gain(std::size_t pass) const {
        return m_context ? m_context->gains.gain(pass) : nullptr;
    }
    /// Whether some passes are not up to date. Calls of update() draw them.
    bool is_pending() const {
        return m_thumbnails.is_pending() || (m_context && m_context->gains.is_pending());
    }

private:
    std::shared_ptr<ContextViews> m_context;  // of the displayed look; null: not created
    Thumbnails m_thumbnails;
    bool m_measures_gains = true;  // alternates with thumbnails
};
