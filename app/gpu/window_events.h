#pragma once

#include "gpu/input_event.h"

#include <filesystem>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace gpu {

/// The events of a window: mouse, keyboard and dropped files.
class WindowEvents {
public:
    /// Listens to a window that has no other listener.
    explicit WindowEvents(GLFWwindow* window);
    WindowEvents(const WindowEvents&) = delete;
    WindowEvents& operator=(const WindowEvents&) = delete;

    /// Processes pending events of all windows, on the main thread.
    static void poll();
    /// As poll(), but first waits for an event, at most `max_seconds`.
    static void wait(double max_seconds);
    /// Ends a wait; can be called from any thread.
    static void wake();

    /// Mouse and keyboard events since the last call, in order.
    std::vector<InputEvent> take_input() { return std::exchange(m_input, {}); }
    bool has_input() const { return !m_input.empty(); }
    /// Files dropped on the window since the last call.
    std::vector<std::filesystem::path> take_dropped_files() { return std::exchange(m_dropped, {}); }

private:
    struct Listeners;  // GLFW callbacks

    std::vector<InputEvent> m_input;
    std::vector<std::filesystem::path> m_dropped;
};

}  // namespace gpu
