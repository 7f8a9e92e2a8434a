#pragma once

#include "gpu/window.h"
#include "lab/window/window_state.h"

#include <memory>
#include <string>

/// The window that shows the picture alone, over all of a display, while the panels stay.
class OutputWindow {
public:
    /// Opens it, closes it or takes it to another display, as `state` wants; closed by the desktop
    /// or by Escape it says so there. Returns what went wrong, "" when nothing did.
    std::string follow(WindowState& state, gpu::Window& panels);
    /// Shows the picture, null: black. The panels' context is current afterwards.
    void show(const gpu::Texture* picture, gpu::Window& panels);
    /// Keys that were pressed on it, for the panels.
    std::vector<gpu::InputEvent> take_keys();
    /// The display that it is on, or would open on.
    std::size_t monitor() const { return m_monitor; }
    /// The panels cannot be seen behind it.
    bool covers_panels() const { return m_covers_panels; }
    bool is_open() const { return m_window != nullptr; }

private:
    std::unique_ptr<gpu::Window> m_window;
    std::size_t m_monitor = 0;
    bool m_covers_panels = false;
    bool m_is_left = false;  // Escape was pressed on it
};
