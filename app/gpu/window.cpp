#include "gpu/window.h"

#include "gpu/driver_cache.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace gpu {

struct Window::Library {
    Library() = default;
    ~Library() { glfwTerminate(); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
};

namespace {
std::string last_problem() {
    const char* words = nullptr;
    glfwGetError(&words);
    return words ? words : "no reason given";
}

void set_hints(const WindowOptions& options) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // required by macOS
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);  // shown after it is positioned
    // Enables notification of driver resets where supported; shared contexts must do the same.
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    glfwWindowHint(GLFW_MAXIMIZED, options.is_maximised && options.is_visible);
}
}  // namespace

Result<std::shared_ptr<Window::Library>> Window::open_library() {
    static std::weak_ptr<Library> open;
    if (auto library = open.lock())
        return library;
    check_driver_cache();
    if (!glfwInit())
        return fail({{}, 0, fmt::format("can't open a window: {}", last_problem())});
    auto library = std::make_shared<Library>();
    open = library;
    return library;
}

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

struct Window::Listeners {
    static Window& of(GLFWwindow* window) {
        return *static_cast<Window*>(glfwGetWindowUserPointer(window));
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

Window::Window(std::shared_ptr<Library> library, GLFWwindow* window)
    : m_library(std::move(library)), m_window(window) {
    glfwSetWindowUserPointer(m_window, this);
    glfwSetDropCallback(m_window, Listeners::drop);
    glfwSetKeyCallback(m_window, Listeners::key);
    glfwSetCharCallback(m_window, Listeners::text);
    glfwSetMouseButtonCallback(m_window, Listeners::button);
    glfwSetCursorPosCallback(m_window, Listeners::pointer);
    glfwSetCursorEnterCallback(m_window, Listeners::enter);
    glfwSetScrollCallback(m_window, Listeners::wheel);
}

Window::~Window() {
    glfwDestroyWindow(m_window);
}

namespace {
/// Limits the size to the display's area without the desktop's bars.
Extent fitted(Extent wanted) {
    Extent room = wanted;
    int left = 0;
    int top = 0;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor())
        glfwGetMonitorWorkarea(monitor, &left, &top, &room.width, &room.height);
    return {std::clamp(wanted.width, 1, std::max(room.width, 1)),
            std::clamp(wanted.height, 1, std::max(room.height, 1))};
}
}  // namespace

Result<std::unique_ptr<Window>> Window::create(const WindowOptions& options, GLFWwindow* shared,
                                               GLFWmonitor* monitor) {
    auto library = open_library();
    if (!library)
        return fail(library.error());
    set_hints(options);
    if (monitor) {  // keep the display's mode, and don't minimise on focus loss
        glfwWindowHint(GLFW_REFRESH_RATE, glfwGetVideoMode(monitor)->refreshRate);
        glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
    }
    const Extent size = monitor ? options.size : fitted(options.size);
    GLFWwindow* made =
        glfwCreateWindow(size.width, size.height, options.title.c_str(), monitor, shared);
    if (!made)
        return fail(
            {{}, 0, fmt::format("can't open a window with OpenGL 4.1: {}", last_problem())});
    return std::unique_ptr<Window>(new Window(std::move(*library), made));
}

namespace {
// GLX must not be called on another kind of display.
bool has_glx(GLFWwindow* window) {
    return std::string_view(glfwGetVersionString()).find("GLX") != std::string_view::npos &&
           glfwGetWindowAttrib(window, GLFW_CONTEXT_CREATION_API) == GLFW_NATIVE_CONTEXT_API;
}
}  // namespace

Result<std::unique_ptr<Window>> Window::open(const WindowOptions& options) {
    auto window = create(options, nullptr);
    if (!window)
        return window;
    GLFWwindow* made = (*window)->m_window;
    constexpr Extent least{480, 320};  // controls overlap below this size
    glfwSetWindowSizeLimits(made, least.width, least.height, GLFW_DONT_CARE, GLFW_DONT_CARE);
    if (options.position && !options.is_maximised)
        glfwSetWindowPos(made, (*options.position)[0], (*options.position)[1]);
    if (options.is_visible)
        glfwShowWindow(made);
    (*window)->make_current();
    (*window)->m_facts = read_facts();
    if (has_glx(made))
        (*window)->m_glx = current_glx_place();
    return window;
}

Result<std::unique_ptr<Context>> Window::make_sharing() const {
    if (auto alone = share_through_glx(m_glx, m_facts))
        return alone;
    auto window = create({"", {16, 16}, std::nullopt, false, false}, m_window);
    if (!window)
        return fail(window.error());
    (*window)->m_facts = m_facts;
    return std::move(*window);
}

void Window::take_thread() {
    glfwMakeContextCurrent(m_window);
}

void Window::leave_thread() {
    glfwMakeContextCurrent(nullptr);
}

void Window::poll_events() {
    glfwPollEvents();
}

void Window::wait_events(double most_seconds) {
    if (most_seconds > 0)  // GLFW rejects a timeout of 0
        glfwWaitEventsTimeout(most_seconds);
    else
        glfwPollEvents();
}

void Window::wake() {
    glfwPostEmptyEvent();
}

void Window::swap() {
    glfwSwapBuffers(m_window);
}

void Window::set_vsync(bool is_on) {
    glfwSwapInterval(is_on ? 1 : 0);
}

bool Window::is_close_requested() const {
    return glfwWindowShouldClose(m_window) == GLFW_TRUE;
}

std::vector<std::filesystem::path> Window::take_dropped_files() {
    return std::exchange(m_dropped, {});
}

std::vector<InputEvent> Window::take_input() {
    return std::exchange(m_input, {});
}

Extent Window::framebuffer_size() const {
    Extent extent;
    glfwGetFramebufferSize(m_window, &extent.width, &extent.height);
    return extent;
}

Extent Window::size() const {
    Extent extent;
    glfwGetWindowSize(m_window, &extent.width, &extent.height);
    return extent;
}

std::array<int, 2> Window::position() const {
    std::array<int, 2> place{};
    glfwGetWindowPos(m_window, place.data(), &place[1]);
    return place;
}

bool Window::is_maximised() const {
    return glfwGetWindowAttrib(m_window, GLFW_MAXIMIZED) == GLFW_TRUE;
}

float Window::content_scale() const {
    float scale = 1.0f;
    glfwGetWindowContentScale(m_window, &scale, nullptr);
    return scale;
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(m_window, title.c_str());
}

std::string Window::clipboard() const {
    const char* text = glfwGetClipboardString(m_window);
    return text ? text : "";
}

void Window::set_clipboard(const std::string& text) {
    glfwSetClipboardString(m_window, text.c_str());
}

}  // namespace gpu
