// The displays of the desktop, and the full-screen window.
#include "gpu/window.h"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <span>

namespace gpu {

namespace {
// Monitors whose resolution is known.
std::vector<GLFWmonitor*> handles() {
    int count = 0;
    GLFWmonitor** all = glfwGetMonitors(&count);
    std::vector<GLFWmonitor*> monitors;
    for (GLFWmonitor* monitor : std::span(all, static_cast<std::size_t>(count)))
        if (glfwGetVideoMode(monitor))
            monitors.push_back(monitor);
    return monitors;
}

}  // namespace

std::vector<Monitor> Window::monitors() {
    std::vector<Monitor> monitors;
    for (GLFWmonitor* handle : handles()) {
        const GLFWvidmode* mode = glfwGetVideoMode(handle);
        monitors.push_back({glfwGetMonitorName(handle), {mode->width, mode->height}});
    }
    return monitors;
}

// Each query blocks on the display server, and this is called every update; cached for 1 s.
const std::vector<Window::Display>& Window::displays() const {
    const auto now = std::chrono::steady_clock::now();
    if (m_displays_read && now - *m_displays_read < std::chrono::seconds(1))
        return m_displays;
    m_displays.clear();
    for (GLFWmonitor* handle : handles()) {
        const GLFWvidmode* mode = glfwGetVideoMode(handle);
        Display display{{}, {mode->width, mode->height}, mode->refreshRate};
        glfwGetMonitorPos(handle, &display.low[0], &display.low[1]);
        m_displays.push_back(display);
    }
    m_displays_read = now;
    return m_displays;
}

std::size_t Window::monitor() const {
    const auto [left, top] = position();
    const Extent extent = size();
    const std::array middle{left + extent.width / 2, top + extent.height / 2};
    const auto holds = [&middle](const Display& display) {
        return middle[0] >= display.low[0] && middle[1] >= display.low[1] &&
               middle[0] < display.low[0] + display.size.width &&
               middle[1] < display.low[1] + display.size.height;
    };
    const std::vector<Display>& all = displays();
    const auto found = std::ranges::find_if(all, holds);
    return found == all.end() ? 0 : static_cast<std::size_t>(found - all.begin());
}

double Window::refresh_rate() const {
    const std::size_t own = monitor();
    const std::vector<Display>& all = displays();  // may have been refreshed since
    const int rate = own < all.size() ? all[own].refresh_rate : 0;
    return rate > 0 ? rate : 60.0;
}

Result<std::unique_ptr<Window>> Window::open_full_screen(std::size_t monitor) {
    const std::vector<GLFWmonitor*> monitors = handles();
    if (monitor >= monitors.size())
        return fail({{}, 0, "this display is no longer connected"});
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[monitor]);
    auto window =
        create({"Afterglow output", {mode->width, mode->height}}, m_window, monitors[monitor]);
    if (!window)
        return window;
    GLFWwindow* made = (*window)->m_window;
    glfwSetInputMode(made, GLFW_CURSOR, GLFW_CURSOR_HIDDEN);
    (*window)->m_facts = m_facts;
    (*window)->make_current();
    (*window)->set_vsync(true);
    make_current();
    return window;
}

void Window::show(const Texture* picture) {
    make_current();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    if (picture) {  // framebuffers are not shared between contexts
        GLuint framebuffer = 0;
        glGenFramebuffers(1, &framebuffer);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
        glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                               picture->id(), 0);
        const Extent extent = picture->extent();
        glBlitFramebuffer(0, 0, extent.width, extent.height, 0, 0, extent.width, extent.height,
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &framebuffer);
    }
    swap();
}

void Window::focus() {
    glfwFocusWindow(m_window);
}

}  // namespace gpu
