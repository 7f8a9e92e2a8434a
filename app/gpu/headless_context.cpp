#include "gpu/headless_context.h"

#include "gpu/driver_cache.h"

#include <epoxy/egl.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace gpu {

namespace {
bool has_word(const char* text, std::string_view word) {
    const std::string_view all = text ? text : "";
    for (std::size_t at = all.find(word); at != std::string_view::npos;
         at = all.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || all[at - 1] == ' ') && (end == all.size() || all[end] == ' '))
            return true;
    }
    return false;
}

// Extension functions come from EGL itself: epoxy ends the process if it finds an extension
// missing.
template <class Function>
Function extension(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

class HeadlessContext : public Context {
public:
    HeadlessContext(EGLDisplay display, EGLConfig config, EGLContext context, EGLSurface surface)
        : m_display(display), m_config(config), m_context(context), m_surface(surface) {}

    // The display stays open: EGL has one per device for the whole process, shared with others.
    ~HeadlessContext() override {
        if (eglGetCurrentContext() == m_context)
            release();
        eglDestroyContext(m_display, m_context);
        if (m_surface != EGL_NO_SURFACE)
            eglDestroySurface(m_display, m_surface);
    }

    /// Null if the display does not support OpenGL 4.1 core.
    static std::unique_ptr<HeadlessContext> make(EGLDisplay display, EGLConfig config,
                                                 EGLContext shared, bool is_for_debugging) {
        const EGLint wanted[] = {
            EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 1,
            EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
            // Without EGL 1.5, this attribute would be an error.
            is_for_debugging ? EGL_CONTEXT_OPENGL_DEBUG : EGL_NONE, EGL_TRUE, EGL_NONE};
        eglBindAPI(EGL_OPENGL_API);
        const EGLContext context = eglCreateContext(display, config, shared, wanted);
        if (context == EGL_NO_CONTEXT)
            return nullptr;
        EGLSurface surface = EGL_NO_SURFACE;
        if (!has_word(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
            constexpr EGLint smallest[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
            surface = eglCreatePbufferSurface(display, config, smallest);
        }
        return std::make_unique<HeadlessContext>(display, config, context, surface);
    }

    /// Makes it current and reads the driver's facts; false if it can't become current.
    bool start() {
        make_current();
        if (eglGetCurrentContext() != m_context)
            return false;
        m_info = read_info();
        return true;
    }

private:
    void take_thread() override {
        eglBindAPI(EGL_OPENGL_API);  // the bound API is per thread
        eglMakeCurrent(m_display, m_surface, m_surface, m_context);
    }

    void leave_thread() override {
        eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }

    Result<std::unique_ptr<Context>> make_sharing() const override {
        auto context = make(m_display, m_config, m_context, m_info.is_debugged);
        if (!context)
            return fail({{}, 0, "the graphics driver can't create a second OpenGL context"});
        context->m_info = m_info;
        return context;
    }

    EGLDisplay m_display;
    EGLConfig m_config;
    EGLContext m_context;
    EGLSurface m_surface;
};

EGLDisplay platform_display(EGLenum platform, void* device) {
    const auto get = extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    return get ? get(platform, device, nullptr) : EGL_NO_DISPLAY;
}

std::vector<EGLDeviceEXT> devices(bool software) {
    const auto query_devices = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const auto query_text = extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    std::array<EGLDeviceEXT, 32> found{};
    EGLint count = 0;
    if (!query_devices || !query_devices(static_cast<EGLint>(found.size()), found.data(), &count))
        return {};
    std::vector<EGLDeviceEXT> wanted;
    for (EGLint i = 0; i < count; ++i) {
        const EGLDeviceEXT device = found[static_cast<std::size_t>(i)];
        const char* text = query_text ? query_text(device, EGL_EXTENSIONS) : nullptr;
        if (has_word(text, "EGL_MESA_device_software") == software)
            wanted.push_back(device);
    }
    return wanted;
}

// Hardware devices first; Mesa's surfaceless platform also finds software drivers.
std::vector<EGLDisplay> displays() {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const bool has_devices = has_word(client, "EGL_EXT_platform_device");
    std::vector<EGLDisplay> all;
    const auto add = [&](EGLDisplay display) {
        if (display != EGL_NO_DISPLAY)
            all.push_back(display);
    };
    if (has_devices && !std::getenv("LIBGL_ALWAYS_SOFTWARE"))
        for (const EGLDeviceEXT device : devices(false))
            add(platform_display(EGL_PLATFORM_DEVICE_EXT, device));
    if (has_word(client, "EGL_MESA_platform_surfaceless"))
        add(platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY));
    if (has_devices)
        for (const EGLDeviceEXT device : devices(true))
            add(platform_display(EGL_PLATFORM_DEVICE_EXT, device));
    if (all.empty())
        add(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return all;
}

std::unique_ptr<HeadlessContext> open_on(EGLDisplay display, bool is_for_debugging) {
    if (!eglInitialize(display, nullptr, nullptr))
        return nullptr;
    constexpr EGLint with_pbuffer[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                       EGL_OPENGL_BIT, EGL_NONE};
    constexpr EGLint with_any[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                   EGL_NONE};
    for (const EGLint* wanted : {with_pbuffer, with_any}) {
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1)
            continue;
        auto context = HeadlessContext::make(display, config, EGL_NO_CONTEXT, is_for_debugging);
        if (context && context->start())
            return context;
    }
    return nullptr;
}
}  // namespace

Result<std::unique_ptr<Context>> create_headless_context(bool is_for_debugging) {
    check_driver_cache();
    const std::vector<EGLDisplay> tried = displays();
    for (const EGLDisplay display : tried)
        if (auto context = open_on(display, is_for_debugging))
            return context;
    return fail({{},
                 0,
                 fmt::format("can't draw without a display: none of the EGL displays supports "
                             "OpenGL 4.1 core (displays tried: {}). Install Mesa's software "
                             "driver, the Debian package libgl1-mesa-dri.",
                             tried.size())});
}

}  // namespace gpu
