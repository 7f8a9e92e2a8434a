#include "ui/window/output_window.h"

#include <fmt/format.h>

#include <algorithm>

std::string OutputWindow::follow(OutputState& state, gpu::Window& panels) {
    if (m_window && (m_is_left || m_window->take_close_request()))
        state.is_open = false;
    m_is_left = false;
    const std::size_t own = panels.display();
    const std::size_t wanted = state.monitor_for(panels.displays().count(), own);
    if (m_window && (!state.is_open || wanted != m_monitor)) {
        m_window.reset();
        panels.context().make_current();
        panels.focus();
    }
    std::string problem;
    if (state.is_open && !m_window) {
        auto opened = panels.open_full_screen(wanted);
        if (opened) {
            m_window = std::move(*opened);
            (wanted == own ? *m_window : panels).focus();
        } else {
            state.is_open = false;
            problem = fmt::format("Can't open the output window: {}", to_string(opened.error()));
        }
    }
    m_monitor = wanted;
    m_covers_panels = m_window && wanted == own;
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
