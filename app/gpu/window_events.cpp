#include "gpu/window_events.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace gpu {

namespace {
// A digit key stays a digit even if the layout needs Shift for it.
int key_of(int code, int scancode) {
    const bool is_digit = code >= GLFW_KEY_0 && code <= GLFW_KEY_9;
    const char* name = glfwGetKeyName(code, scancode);
    if (is_digit || !name || name[0] <= ' ' || name[0] > '~' || name[1] != '\0')
        return code;
    return name[0] >= 'a' && name[0] <= 'z' ? name[0] - 'a' + 'A' : name[0];
}
}  // namespace

struct WindowEvents::Listeners {
    static WindowEvents& of(GLFWwindow* window) {
        return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
    }
    static void add(GLFWwindow* window, InputEvent event) { of(window).m_input.push_back(event); }
    static void drop(GLFWwindow* window, int count, const char** paths) {
        of(window).m_dropped.insert(of(window).m_dropped.end(), paths, paths + count);
    }
    static void key(GLFWwindow* window, int code, int scancode, int action, int /*modifiers*/) {
        if (action != GLFW_REPEAT && code != GLFW_KEY_UNKNOWN)
            add(window, KeyEvent{key_of(code, scancode), action == GLFW_PRESS});
    }
    static void text(GLFWwindow* window, unsigned int code_point) {
        add(window, TextEvent{code_point});
    }
    static void button(GLFWwindow* window, int button, int action, int /*modifiers*/) {
        add(window, ButtonEvent{button, action == GLFW_PRESS});
    }
    static void pointer(GLFWwindow* window, double x, double y) {
        add(window, PointerEvent{static_cast<float>(x), static_cast<float>(y)});
    }
    static void enter(GLFWwindow* window, int is_inside) {
        if (!is_inside) {
            add(window, PointerLeftEvent{});
            return;
        }
        double x = 0.0;
        double y = 0.0;
        glfwGetCursorPos(window, &x, &y);
        pointer(window, x, y);
    }
    static void wheel(GLFWwindow* window, double x, double y) {
        add(window, WheelEvent{static_cast<float>(x), static_cast<float>(y)});
    }
};

WindowEvents::WindowEvents(GLFWwindow* window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetDropCallback(window, Listeners::drop);
    glfwSetKeyCallback(window, Listeners::key);
    glfwSetCharCallback(window, Listeners::text);
    glfwSetMouseButtonCallback(window, Listeners::button);
    glfwSetCursorPosCallback(window, Listeners::pointer);
    glfwSetCursorEnterCallback(window, Listeners::enter);
    glfwSetScrollCallback(window, Listeners::wheel);
}

void WindowEvents::poll() {
    glfwPollEvents();
}

void WindowEvents::wait(double max_seconds) {
    if (max_seconds > 0)  // GLFW rejects a timeout of 0
        glfwWaitEventsTimeout(max_seconds);
    else
        glfwPollEvents();
}

void WindowEvents::wake() {
    glfwPostEmptyEvent();
}

}  // namespace gpu
