#include "gpu/displays.h"

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

GLFWmonitor* Displays::find(std::size_t display) {
    const std::vector<GLFWmonitor*> monitors = handles();
    return display < monitors.size() ? monitors[display] : nullptr;
}

const std::vector<Displays::Display>& Displays::all() const {
    const auto now = std::chrono::steady_clock::now();
    if (m_read && now - *m_read < std::chrono::seconds(1))
        return m_displays;
    m_displays.clear();
    for (GLFWmonitor* handle : handles()) {
        const GLFWvidmode* mode = glfwGetVideoMode(handle);
        Display display{{}, {mode->width, mode->height}, mode->refreshRate};
        glfwGetMonitorPos(handle, &display.low[0], &display.low[1]);
        m_displays.push_back(display);
    }
    m_read = now;
    return m_displays;
}

std::size_t Displays::at(const std::array<int, 2>& position) const {
    const auto holds = [&position](const Display& display) {
        return position[0] >= display.low[0] && position[1] >= display.low[1] &&
               position[0] < display.low[0] + display.size.width &&
               position[1] < display.low[1] + display.size.height;
    };
    const std::vector<Display>& displays = all();
    const auto found = std::ranges::find_if(displays, holds);
    return found == displays.end() ? 0 : static_cast<std::size_t>(found - displays.begin());
}

double Displays::refresh_rate(std::size_t display) const {
    const std::vector<Display>& displays = all();
    const int rate = display < displays.size() ? displays[display].refresh_rate : 0;
    return rate > 0 ? rate : 60.0;
}

}  // namespace gpu
