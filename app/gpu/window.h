#pragma once

#include "gpu/context.h"
#include "gpu/glx_context.h"
#include "gpu/input_event.h"
#include "gpu/objects/texture.h"
#include "model/look/extent.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

struct GLFWmonitor;
struct GLFWwindow;

namespace gpu {

struct WindowOptions {
    std::string title = "";
    Extent size{1280, 800};  // screen coordinates
    std::optional<std::array<int, 2>> position = std::nullopt;
    bool is_maximised = false;
    bool is_visible = true;
};

/// A display of the desktop.
struct Monitor {
    std::string name;
    Extent size;  // screen coordinates

    bool operator==(const Monitor&) const = default;
};

/// A desktop window with its own context. Made and used on the main thread, except wake(),
/// make_current() and release().
class Window : public Context {
public:
    /// Its context is current. Fails with a message without a display or OpenGL 4.1.
    static Result<std::unique_ptr<Window>> open(const WindowOptions& options);
    ~Window() override;

    /// All displays, the primary one first; names need not be unique.
    static std::vector<Monitor> monitors();
    /// The number of displays. This, monitor() and refresh_rate() are cached for a second.
    std::size_t monitor_count() const { return displays().size(); }
    /// The index in monitors() of the display that contains the window's centre.
    std::size_t monitor() const;
    /// A window without frame or pointer that covers a display at its current resolution. It shares
    /// this window's textures and stays open when another window is focused. Makes this window's
    /// context current afterwards.
    Result<std::unique_ptr<Window>> open_full_screen(std::size_t monitor);
    /// Displays only a picture, aligned with the window's bottom left corner; null: black. Leaves
    /// the window's context current.
    void show(const Texture* picture);
    /// Requests keyboard focus.
    void focus();

    /// Processes pending events.
    void poll_events();
    /// As poll_events, but first waits for an event, at most `most_seconds`.
    void wait_events(double most_seconds);
    /// Ends a wait; can be called from any thread.
    static void wake();
    void swap();
    /// Whether swap waits for the vertical retrace.
    void set_vsync(bool is_on);

    bool is_close_requested() const;
    /// Files dropped on the window since the last call.
    std::vector<std::filesystem::path> take_dropped_files();
    /// Mouse and keyboard events since the last call, in order.
    std::vector<InputEvent> take_input();
    bool has_input() const { return !m_input.empty(); }

    /// Device pixels; empty while minimised.
    Extent framebuffer_size() const;
    /// Screen coordinates, as in WindowOptions.
    Extent size() const;
    std::array<int, 2> position() const;
    bool is_maximised() const;
    /// The display's DPI relative to the default: 1 on a standard display, 2 on a high-DPI display.
    float content_scale() const;
    /// Of the window's display, Hz; 60 if unknown.
    double refresh_rate() const;

    void set_title(const std::string& title);
    std::string clipboard() const;
    void set_clipboard(const std::string& text);

    /// The GLFW window, for a toolkit's backend.
    void* native() const { return m_window; }

private:
    struct Library;  // GLFW, initialised while any window exists

    Window(std::shared_ptr<Library> library, GLFWwindow* window);
    Result<std::unique_ptr<Context>> make_sharing() const override;
    void take_thread() override;
    void leave_thread() override;
    static Result<std::unique_ptr<Window>> create(const WindowOptions& options, GLFWwindow* shared,
                                                  GLFWmonitor* monitor = nullptr);
    static Result<std::shared_ptr<Library>> open_library();
    struct Listeners;  // GLFW callbacks
    /// A display's position on the desktop.
    struct Display {
        std::array<int, 2> low;
        Extent size;
        int refresh_rate = 0;  // 0: unknown
    };
    const std::vector<Display>& displays() const;

    std::shared_ptr<Library> m_library;  // terminates GLFW with the last window
    GLFWwindow* m_window;
    GlxPlace m_glx;
    mutable std::vector<Display> m_displays;
    mutable std::optional<std::chrono::steady_clock::time_point> m_displays_read;
    std::vector<std::filesystem::path> m_dropped;
    std::vector<InputEvent> m_input;
};

}  // namespace gpu
