#include "portable_player/gl.h"

#include "portable_player/error.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <string_view>

#define PLAYER_GL_DEFINE(name, TYPE) PFNGL##TYPE##PROC gl##name = nullptr;
PLAYER_GL_FUNCTIONS(PLAYER_GL_DEFINE)
#undef PLAYER_GL_DEFINE

namespace {
template <class Function>
void find(Function& function, const char* name) {
    function = reinterpret_cast<Function>(eglGetProcAddress(name));
    if (!function)
        throw Error(std::string("the graphics driver has no function ") + name);
}

EGLDisplay open_display() {
    const char* const extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (extensions && std::string_view(extensions).find("EGL_MESA_platform_surfaceless") !=
                          std::string_view::npos) {
        const EGLDisplay display =
            eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (eglInitialize(display, nullptr, nullptr))
            return display;
    }
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (!eglInitialize(display, nullptr, nullptr))
        throw Error("can't open a display of EGL");
    return display;
}
}  // namespace

void open_context() {
    const EGLDisplay display = open_display();
    constexpr EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT, EGL_NONE};
    constexpr EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  4,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  1,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
    constexpr EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglBindAPI(EGL_OPENGL_API);
    eglChooseConfig(display, wanted, &config, 1, &count);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    if (count == 0 || context == EGL_NO_CONTEXT ||
        !eglMakeCurrent(display, surface, surface, context))
        throw Error("the graphics driver has no OpenGL 4.1");
#define PLAYER_GL_FIND(name, TYPE) find(gl##name, "gl" #name);
    PLAYER_GL_FUNCTIONS(PLAYER_GL_FIND)
#undef PLAYER_GL_FIND
}
