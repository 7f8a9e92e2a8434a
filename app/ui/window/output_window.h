#pragma once

#include "gpu/window.h"
#include "lab/output/source_overlay.h"
#include "lab/window/output_state.h"

#include <memory>
#include <optional>
#include <string>

/// The window that shows only the picture: full-screen, on a second display if available, or over
/// the window of another program that the source shows.
class OutputWindow {
public:
    /// Opens, closes or moves the window as `state` requires. If the desktop or Escape closed it,
    /// `state` is updated. `source_window`: the title of the window that the source shows; "":
    /// none. Returns the error; "": no error.
    std::string follow(OutputState& state, const std::string& source_window, gpu::Window& panels);
    /// Shows the picture; null: black. Afterwards the panels' context is current.
    void show(const gpu::Texture* picture, gpu::Window& panels);
    /// The key presses in this window, for the panels.
    std::vector<gpu::InputEvent> take_keys();
    /// The display of the window, or where it would open.
    std::size_t monitor() const { return m_monitor; }
    /// Whether it hides the panels.
    bool covers_panels() const { return m_covers_panels; }
    bool is_open() const { return m_window != nullptr; }
    /// Whether it is over the window of another program.
    bool is_overlay() const { return m_overlay.has_value(); }
    /// In pixels; empty: closed.
    Extent extent() const { return m_window ? m_window->framebuffer_size() : Extent{}; }

private:
    Result<void> open(const OutputState& state, const std::string& source_window,
                      gpu::Window& panels);
    void close(gpu::Window& panels);

    std::unique_ptr<gpu::Window> m_window;
    std::optional<SourceOverlay> m_overlay;  // nullopt: full-screen
    std::size_t m_monitor = 0;
    bool m_covers_panels = false;
    bool m_is_left = false;  // Escape was pressed in it
};
