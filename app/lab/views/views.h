#pragma once

#include "lab/inspect/pins.h"
#include "lab/inspect/readouts.h"
#include "lab/inspect/texel_inspector.h"
#include "lab/views/inspector_view.h"
#include "lab/views/main_view.h"
#include "lab/views/strip_view.h"

#include <array>
#include <memory>
#include <optional>

class Lab;

/// The views of the open look for the window, and the probed values.
class Views {
public:
    static Result<Views> make();

    /// Draws the visible views. Call it after Lab::update().
    void update(const Lab& lab, const WindowState& window);

    const MainView& main() const { return m_main; }
    const InspectorView& inspector() const { return m_inspector; }
    const StripView& strip() const { return m_strip; }
    /// The values of all passes at the pins; empty while the pins are hidden.
    const Pins& pins() const { return m_pins; }
    const Readouts& readouts() const { return m_readouts; }
    /// Texel values and values along a line; empty while hidden.
    const TexelInspector& texels() const { return m_texels; }
    /// The stored values of the pixel at Probes::pointer.
    const std::optional<std::array<float, 4>>& probed() const { return m_probed; }
    /// A display-encoded thumbnail of a pass; nullopt: no memory, or the views belong to another
    /// look.
    std::optional<gpu::Texture> thumbnail(const Lab& lab, int pass, Extent extent);
    /// Whether displays still change for a while although the lab is idle.
    bool is_transitioning() const;
    /// Whether some views do not show the current picture yet. Calls of update() draw them, even
    /// while paused.
    bool is_pending() const { return m_strip.is_pending() || m_texels.is_pending(); }

private:
    Views(MainView main_view, Pins pins, Readouts readouts, TexelInspector texels);
    void set_context(std::shared_ptr<ContextViews> context);
    void probe(const Executor& executor, const std::optional<Probe>& probe);

    std::shared_ptr<ContextViews> m_context;  // of the displayed look; null: not created
    MainView m_main;
    InspectorView m_inspector;
    StripView m_strip;
    Pins m_pins;
    Readouts m_readouts;
    TexelInspector m_texels;
    bool m_is_first = true;  // before the first update
    std::optional<std::array<float, 4>> m_probed;
};

/// The probed texel of the displayed pass at a position of the picture, px from the top left.
Probe picture_probe(const Executor& executor, int pass, Extent picture,
                    const std::array<double, 2>& position);
