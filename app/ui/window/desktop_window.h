#pragma once

#include "gpu/window.h"
#include "lab/window/window_state.h"

#include <optional>
#include <string>

/// The options for a window with the stored geometry.
gpu::WindowOptions geometry_of(const WindowGeometry& geometry);

/// The title, vertical sync and stored geometry of the window.
class DesktopWindow {
public:
    explicit DesktopWindow(gpu::Window& window) : m_window(window) {}

    /// `open`: the name of the open look; "": none.
    void set_title(const std::string& open);
    void set_vsync(bool waits_for_display);
    /// Stores size and position.
    void note_geometry(WindowGeometry& geometry) const;

private:
    gpu::Window& m_window;
    std::string m_title;
    std::optional<bool> m_waits_for_display;  // as last set
};
