#include "ui/window/desktop_window.h"

#include <fmt/format.h>

#include <utility>

gpu::WindowOptions geometry_of(const WindowGeometry& geometry) {
    return {.title = "Afterglow",
            .size = geometry.size,
            .position = geometry.position,
            .is_maximised = geometry.is_maximised};
}

void DesktopWindow::set_title(const std::string& open) {
    std::string title = open.empty() ? "Afterglow" : fmt::format("{} – Afterglow", open);
    if (title != m_title)
        m_window.set_title(m_title = std::move(title));
}

void DesktopWindow::set_vsync(bool waits_for_display) {
    if (waits_for_display != m_waits_for_display)
        m_window.set_vsync(*(m_waits_for_display = waits_for_display));
}

void DesktopWindow::note_geometry(WindowGeometry& geometry) const {
    geometry.is_maximised = m_window.is_maximised();
    if (geometry.is_maximised)
        return;
    geometry.size = m_window.size();
    geometry.position = m_window.position();
}
