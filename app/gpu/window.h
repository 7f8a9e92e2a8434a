#pragma once

#include "gpu/displays.h"
#include "gpu/glfw_context.h"
#include "gpu/objects/texture.h"
#include "gpu/window_events.h"

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace gpu {

/// A desktop window with its own context. Made and used on the main thread.
class Window {
public:
    /// Its context is current. Fails with a message without a display or OpenGL 4.1.
    static Result<std::unique_ptr<Window>> open(const WindowOptions& options);
    /// A window without frame or pointer that covers a display at its current resolution, or is
    /// hidden without a display. It shares this window's textures and stays open when another
    /// window is focused. Makes this window's context current afterwards.
    Result<std::unique_ptr<Window>> open_output(std::optional<std::size_t> display);

    Context& context() { return *m_context; }
    WindowEvents& events() { return m_events; }
    const WindowEvents& events() const { return m_events; }
    /// Whether the user has asked to close it since the last call.
    bool take_close_request();

    const Displays& displays() const { return m_displays; }
    /// The index of the display that contains the window's centre.
    std::size_t display() const;
    /// Of that display, Hz; 60 if unknown.
    double refresh_rate() const { return m_displays.refresh_rate(display()); }

    /// Displays only a picture, aligned with the window's bottom left corner; null: black. Leaves
    /// the window's context current.
    void show(const Texture* picture);
    void swap();
    /// Whether swap waits for the vertical retrace.
    void set_vsync(bool is_on);

    /// Requests keyboard focus.
    void focus();
    /// Device pixels; empty while minimised.
    Extent framebuffer_size() const;
    /// Screen coordinates, as in WindowOptions.
    Extent size() const;
    std::array<int, 2> position() const;
    bool is_maximised() const;
    /// The display's DPI relative to the default: 1 on a standard display, 2 on a high-DPI display.
    float content_scale() const;
    void set_title(const std::string& title);
    void set_clipboard(const std::string& text);

    /// The GLFW window, for a toolkit's backend.
    void* native() const { return handle(); }

private:
    explicit Window(std::unique_ptr<GlfwContext> context);
    GLFWwindow* handle() const { return m_context->window(); }

    std::unique_ptr<GlfwContext> m_context;
    WindowEvents m_events;
    Displays m_displays;
};

}  // namespace gpu
