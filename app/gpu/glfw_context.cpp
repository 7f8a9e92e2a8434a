#include "gpu/glfw_context.h"

#include "gpu/driver_cache.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace gpu {

struct GlfwContext::Library {
    Library() = default;
    ~Library() { glfwTerminate(); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
};

namespace {
std::string last_problem() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

void set_hints(const WindowOptions& options) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // required by macOS
    // The desktop finds the icon of the window by these names.
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "Afterglow");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "afterglow");
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);  // shown after it is positioned
    // Enables notification of driver resets where supported; shared contexts must do the same.
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    glfwWindowHint(GLFW_MAXIMIZED, options.is_maximised && options.is_visible);
}
}  // namespace

Result<std::shared_ptr<GlfwContext::Library>> GlfwContext::open_library() {
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

Result<std::unique_ptr<GlfwContext>> GlfwContext::create(const WindowOptions& options,
                                                         const GlfwContext* shared,
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
    GLFWwindow* made = glfwCreateWindow(size.width, size.height, options.title.c_str(), monitor,
                                        shared ? shared->m_window : nullptr);
    if (!made)
        return fail(
            {{}, 0, fmt::format("can't open a window with OpenGL 4.1: {}", last_problem())});
    std::unique_ptr<GlfwContext> context(new GlfwContext(std::move(*library), made));
    if (shared)
        context->m_info = shared->m_info;
    return context;
}

GlfwContext::~GlfwContext() {
    glfwDestroyWindow(m_window);
}

namespace {
// GLX must not be called on another kind of display.
bool has_glx(GLFWwindow* window) {
    return std::string_view(glfwGetVersionString()).find("GLX") != std::string_view::npos &&
           glfwGetWindowAttrib(window, GLFW_CONTEXT_CREATION_API) == GLFW_NATIVE_CONTEXT_API;
}
}  // namespace

void GlfwContext::start() {
    make_current();
    m_info = read_info();
    if (has_glx(m_window))
        m_glx = current_glx_handles();
}

Result<std::unique_ptr<Context>> GlfwContext::make_sharing() const {
    if (auto alone = share_through_glx(m_glx, m_info))
        return alone;
    auto context = create({"", {16, 16}, std::nullopt, false, false}, this);
    if (!context)
        return fail(context.error());
    return std::move(*context);
}

void GlfwContext::take_thread() {
    glfwMakeContextCurrent(m_window);
}

void GlfwContext::leave_thread() {
    glfwMakeContextCurrent(nullptr);
}

}  // namespace gpu
