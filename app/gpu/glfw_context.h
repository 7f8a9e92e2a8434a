#pragma once

#include "gpu/context.h"
#include "gpu/glx_context.h"
#include "model/look/extent.h"

#include <array>
#include <memory>
#include <optional>
#include <string>

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

/// An OpenGL context and its window, which GLFW creates together. Made and destroyed on the main
/// thread.
class GlfwContext : public Context {
public:
    /// A hidden window, or a full-screen one on a monitor at its current resolution. Shares the
    /// objects of `shared`. Fails with a message without a display or OpenGL 4.1.
    static Result<std::unique_ptr<GlfwContext>> create(const WindowOptions& options,
                                                       const GlfwContext* shared = nullptr,
                                                       GLFWmonitor* monitor = nullptr);
    ~GlfwContext() override;

    GLFWwindow* window() const { return m_window; }
    /// Makes an unshared context current, and reads its facts.
    void start();

private:
    struct Library;  // GLFW, initialised while any context exists

    GlfwContext(std::shared_ptr<Library> library, GLFWwindow* window)
        : m_library(std::move(library)), m_window(window) {}
    static Result<std::shared_ptr<Library>> open_library();
    Result<std::unique_ptr<Context>> make_sharing() const override;
    void take_thread() override;
    void leave_thread() override;

    std::shared_ptr<Library> m_library;  // terminates GLFW with the last context
    GLFWwindow* m_window;
    GlxHandles m_glx;
};

}  // namespace gpu
