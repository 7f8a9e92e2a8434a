#include "gpu/window.h"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

namespace gpu {

Window::Window(std::unique_ptr<GlfwContext> context)
    : m_context(std::move(context)), m_events(handle()) {}

Result<std::unique_ptr<Window>> Window::open(const WindowOptions& options) {
    auto context = GlfwContext::create(options);
    if (!context)
        return fail(context.error());
    std::unique_ptr<Window> window(new Window(std::move(*context)));
    GLFWwindow* made = window->handle();
    constexpr Extent minimum{480, 320};  // controls overlap below this size
    glfwSetWindowSizeLimits(made, minimum.width, minimum.height, GLFW_DONT_CARE, GLFW_DONT_CARE);
    if (options.position && !options.is_maximised)
        glfwSetWindowPos(made, (*options.position)[0], (*options.position)[1]);
    if (options.is_visible)
        glfwShowWindow(made);
    window->m_context->start();
    return window;
}

Result<std::unique_ptr<Window>> Window::open_output(std::optional<std::size_t> display) {
    GLFWmonitor* monitor = display ? Displays::find(*display) : nullptr;
    if (display && !monitor)
        return fail(
            {{},
             0,
             "The display is no longer connected. Choose another display for the output window."});
    WindowOptions options{.title = "Afterglow output"};
    if (const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr)
        options.size = {mode->width, mode->height};
    auto context = GlfwContext::create(options, m_context.get(), monitor);
    if (!context)
        return fail(context.error());
    std::unique_ptr<Window> window(new Window(std::move(*context)));
    glfwSetInputMode(window->handle(), GLFW_CURSOR, GLFW_CURSOR_HIDDEN);
    window->m_context->make_current();
    window->set_vsync(true);
    m_context->make_current();
    return window;
}

std::size_t Window::display() const {
    const auto [left, top] = position();
    const Extent extent = size();
    return m_displays.at({left + extent.width / 2, top + extent.height / 2});
}

void Window::show(const Texture* picture) {
    m_context->make_current();
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
    glfwFocusWindow(handle());
}

void Window::swap() {
    glfwSwapBuffers(handle());
}

void Window::set_vsync(bool is_on) {
    glfwSwapInterval(is_on ? 1 : 0);
}

bool Window::take_close_request() {
    const bool is_asked = glfwWindowShouldClose(handle()) == GLFW_TRUE;
    glfwSetWindowShouldClose(handle(), GLFW_FALSE);
    return is_asked;
}

Extent Window::framebuffer_size() const {
    Extent extent;
    glfwGetFramebufferSize(handle(), &extent.width, &extent.height);
    return extent;
}

Extent Window::size() const {
    Extent extent;
    glfwGetWindowSize(handle(), &extent.width, &extent.height);
    return extent;
}

std::array<int, 2> Window::position() const {
    std::array<int, 2> position{};
    glfwGetWindowPos(handle(), position.data(), &position[1]);
    return position;
}

bool Window::is_maximised() const {
    return glfwGetWindowAttrib(handle(), GLFW_MAXIMIZED) == GLFW_TRUE;
}

float Window::content_scale() const {
    float scale = 1.0f;
    glfwGetWindowContentScale(handle(), &scale, nullptr);
    return scale;
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(handle(), title.c_str());
}

void Window::set_clipboard(const std::string& text) {
    glfwSetClipboardString(handle(), text.c_str());
}

}  // namespace gpu
