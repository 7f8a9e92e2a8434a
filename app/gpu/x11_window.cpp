#include "gpu/x11_window.h"

#include <GLFW/glfw3.h>

// As in GLFW/glfw3native.h, which also needs the headers of Xrandr. An X11 Window is an unsigned
// long.
extern "C" unsigned long glfwGetX11Window(GLFWwindow* window);

std::uint64_t gpu::x11_window(const Window& window) {
    return glfwGetX11Window(static_cast<GLFWwindow*>(window.native()));
}
