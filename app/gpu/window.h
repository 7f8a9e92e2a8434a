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

/// A window on the desktop with the context that draws into it. Made and used on the main thread,
/// but for wake(), make_current() and release().
class Window : public Context {
public:
    /// Its context is current. Fails in plain words without a display or OpenGL 4.1.
    static Result<std::unique_ptr<Window>> open(const WindowOptions& options);
    ~Window() override;

    /// The displays there are, the first one first; several may have the same name.
    static std::vector<Monitor> monitors();
    /// How many these are; this, monitor() and refresh_rate() as they were within the last second.
    std::size_t monitor_count() const { return displays().size(); }
    /// The display that most of the window's middle is on, by its place in monitors().
    std::size_t monitor() const;
    /// A window without frame or pointer over all of a display, at its present resolution, that
    /// shares this one's textures and stays when another window gets the keyboard. This window's
    /// context is current afterwards.
    Result<std::unique_ptr<Window>> open_full_screen(std::size_t monitor);
    /// Shows a picture alone, its bottom left corner in the window's; null: black. Leaves the
    /// window's context current.
    void show(const Texture* picture);
    /// Asks the desktop for the keyboard.
    void focus();

    /// Handles what has happened since last asked.
    void poll_events();
    /// As poll_events, but first sleeps until something happens or `most_seconds` are over.
    void wait_events(double most_seconds);
    /// Ends a wait; from any thread.
    static void wake();
    /// Shows what was drawn.
    void swap();
    /// Whether swap waits for the display.
    void set_vsync(bool is_on);

    bool is_close_requested() const;
    /// The person stays after all.
    void refuse_close();
    /// Files dropped on it since last asked.
    std::vector<std::filesystem::path> take_dropped_files();
    /// What mouse and keyboard did since last asked, in order.
    std::vector<InputEvent> take_input();
    bool has_input() const { return !m_input.empty(); }

    /// Device pixels; empty while minimised.
    Extent framebuffer_size() const;
    /// Screen coordinates, as WindowOptions takes it.
    Extent size() const;
    std::array<int, 2> position() const;
    bool is_maximised() const;
    bool is_focused() const;
    /// Device pixels of a point of text; 1 on a plain display, 2 on a fine one.
    float content_scale() const;
    /// Of the display it is on; 60 where that is not known.
    double refresh_rate() const;

    void set_title(const std::string& title);
    std::string clipboard() const;
    void set_clipboard(const std::string& text);

    /// GLFW's window, for a toolkit's backend.
    void* native() const { return m_window; }

private:
    struct Library;  // GLFW itself, open as long as any window

    Window(std::shared_ptr<Library> library, GLFWwindow* window);
    Result<std::unique_ptr<Context>> make_sharing() const override;
    void take_thread() override;
    void leave_thread() override;
    static Result<std::unique_ptr<Window>> create(const WindowOptions& options, GLFWwindow* shared,
                                                  GLFWmonitor* monitor = nullptr);
    static Result<std::shared_ptr<Library>> open_library();
    struct Listeners;  // what GLFW calls
    /// Where a display lies on the desktop.
    struct Display {
        std::array<int, 2> low;
        Extent size;
        int refresh_rate = 0;  // 0: not known
    };
    const std::vector<Display>& displays() const;

    std::shared_ptr<Library> m_library;  // shared: the last window of several closes it
    GLFWwindow* m_window;
    GlxPlace m_glx;
    mutable std::vector<Display> m_displays;
    mutable std::optional<std::chrono::steady_clock::time_point> m_displays_read;
    std::vector<std::filesystem::path> m_dropped;
    std::vector<InputEvent> m_input;
};

}  // namespace gpu
