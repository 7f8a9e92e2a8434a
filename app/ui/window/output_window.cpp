#include "ui/window/output_window.h"

#include "gpu/x11_window.h"

#include <fmt/format.h>

#include <algorithm>

Result<void> OutputWindow::open(const OutputState& state, const std::string& source_window,
                                gpu::Window& panels) {
    auto window = panels.open_output(state.is_overlay ? std::nullopt : std::optional(m_monitor));
    if (!window)
        return fail(window.error());
    if (state.is_overlay) {
        auto overlay = SourceOverlay::open(gpu::x11_window(**window), source_window);
        if (!overlay)
            return fail(overlay.error());
        m_overlay.emplace(std::move(*overlay));
    }
    m_window = std::move(*window);
    return {};
}

void OutputWindow::close(gpu::Window& panels) {
    m_overlay.reset();
    m_window.reset();
    panels.context().make_current();
}

std::string OutputWindow::follow(OutputState& state, const std::string& source_window,
                                 gpu::Window& panels) {
    if (m_window && (m_is_left || m_window->take_close_request()))
        state.is_open = false;
    m_is_left = false;
    if (m_overlay && state.is_open && state.is_overlay && source_window.empty())
        state.is_open = false;
    const std::size_t own = panels.display();
    const std::size_t wanted = state.monitor_for(panels.displays().count(), own);
    const bool is_same = state.is_overlay ? m_overlay && m_overlay->title() == source_window
                                          : !m_overlay && wanted == m_monitor;
    m_monitor = wanted;
    if (m_window && (!state.is_open || !is_same)) {
        const bool was_overlay = m_overlay.has_value();
        close(panels);
        if (!was_overlay)
            panels.focus();
    }
    std::string problem;
    if (state.is_open && !m_window) {
        const auto opened = open(state, source_window, panels);
        if (!opened) {
            panels.context().make_current();
            state.is_open = false;
            problem =
                fmt::format("Can't open the {}: {}", state.is_overlay ? "overlay" : "output window",
                            to_string(opened.error()));
        } else if (!state.is_overlay) {
            (wanted == own ? *m_window : panels).focus();
        }
    }
    m_covers_panels = m_window && !m_overlay && wanted == own;
    return problem;
}

void OutputWindow::show(const gpu::Texture* picture, gpu::Window& panels) {
    if (!m_window)
        return;
    m_window->show(picture);
    panels.context().make_current();
}

std::vector<gpu::InputEvent> OutputWindow::take_keys() {
    if (!m_window)
        return {};
    std::vector<gpu::InputEvent> keys;
    for (const gpu::InputEvent& event : m_window->events().take_input())
        if (const auto* key = std::get_if<gpu::KeyEvent>(&event)) {
            if (key->key == gpu::key::escape)
                m_is_left = m_is_left || key->is_down;
            else
                keys.push_back(event);
        }
    return keys;
}
