#include "gpu/glx_context.h"

#include <epoxy/gl.h>
#include <epoxy/glx.h>

#include <array>
#include <cstring>

namespace gpu {

namespace {
/// Records X errors during its lifetime; the default handler would end the program.
class HeardRefusals {
public:
    explicit HeardRefusals(Display* display)
        : m_display(display), m_before(XSetErrorHandler(&HeardRefusals::hear)) {
        any = false;
    }
    ~HeardRefusals() { XSetErrorHandler(m_before); }
    HeardRefusals(const HeardRefusals&) = delete;
    HeardRefusals& operator=(const HeardRefusals&) = delete;

    bool has_any() const {
        XSync(m_display, False);
        return any;
    }

private:
    static int hear(Display* /*display*/, XErrorEvent* /*refusal*/) {
        any = true;
        return 0;
    }
    static inline bool any = false;  // static: Xlib handlers get no user data

    Display* m_display;
    XErrorHandler m_before;
};

class GlxContext : public Context {
public:
    GlxContext(Display* display, GLXContext context, const DriverInfo& info)
        : m_display(display), m_context(context) {
        m_info = info;
    }
    ~GlxContext() override {
        if (glXGetCurrentContext() == m_context)
            leave_thread();
        glXDestroyContext(m_display, m_context);
    }

private:
    Result<std::unique_ptr<Context>> make_sharing() const override {
        if (auto made = share_through_glx({m_display, m_context}, m_info))
            return made;
        return fail({{}, 0, "can't create another OpenGL 4.1 context"});
    }
    void take_thread() override { glXMakeContextCurrent(m_display, None, None, m_context); }
    void leave_thread() override { glXMakeContextCurrent(m_display, None, None, nullptr); }

    Display* m_display;
    GLXContext m_context;
};

bool can_choose_version(Display* display, int screen) {
    const char* text = glXQueryExtensionsString(display, screen);
    return text && std::strstr(text, "GLX_ARB_create_context_profile");
}

// Contexts can share only if their reset notification strategies are the same.
bool loses_context_on_reset() {
    GLint strategy = 0;
    if (epoxy_has_gl_extension("GL_ARB_robustness"))
        glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY_ARB, &strategy);
    return strategy == GL_LOSE_CONTEXT_ON_RESET_ARB;
}

// Uses the same framebuffer configuration, so that the contexts can share. Null on failure.
GLXContext create_shared(GLXContext context, Display* display) {
    int kind = 0;
    int screen = 0;
    int count = 0;
    glXQueryContext(display, context, GLX_FBCONFIG_ID, &kind);
    glXQueryContext(display, context, GLX_SCREEN, &screen);
    const std::array<int, 3> wanted{GLX_FBCONFIG_ID, kind, None};
    GLXFBConfig* const found = glXChooseFBConfig(display, screen, wanted.data(), &count);
    if (!found)
        return nullptr;
    const bool is_robust = loses_context_on_reset();
    const int flags = GLX_CONTEXT_FORWARD_COMPATIBLE_BIT_ARB |
                      (is_robust ? GLX_CONTEXT_ROBUST_ACCESS_BIT_ARB : 0);
    const std::array<int, 11> version{GLX_CONTEXT_MAJOR_VERSION_ARB,
                                      4,
                                      GLX_CONTEXT_MINOR_VERSION_ARB,
                                      1,
                                      GLX_CONTEXT_PROFILE_MASK_ARB,
                                      GLX_CONTEXT_CORE_PROFILE_BIT_ARB,
                                      GLX_CONTEXT_FLAGS_ARB,
                                      flags,
                                      is_robust ? GLX_CONTEXT_RESET_NOTIFICATION_STRATEGY_ARB : 0,
                                      is_robust ? GLX_LOSE_CONTEXT_ON_RESET_ARB : 0,
                                      None};
    const GLXContext made =
        count > 0 && can_choose_version(display, screen)
            ? glXCreateContextAttribsARB(display, found[0], context, True, version.data())
            : nullptr;
    XFree(found);
    return made;
}

// Some drivers require a drawable.
bool can_be_current_alone(Display* display, GLXContext context) {
    const GLXContext before = glXGetCurrentContext();
    const GLXDrawable draw = glXGetCurrentDrawable();
    const GLXDrawable read = glXGetCurrentReadDrawable();
    const bool can = glXMakeContextCurrent(display, None, None, context) == True;
    glXMakeContextCurrent(display, draw, read, before);
    return can;
}
}  // namespace

GlxHandles current_glx_handles() {
    return {glXGetCurrentDisplay(), glXGetCurrentContext()};
}

std::unique_ptr<Context> share_through_glx(const GlxHandles& handles, const DriverInfo& info) {
    auto* const display = static_cast<Display*>(handles.display);
    if (!display)
        return nullptr;
    const HeardRefusals refusals(display);
    const GLXContext made = create_shared(static_cast<GLXContext>(handles.context), display);
    if (!made)
        return nullptr;
    const bool is_good = can_be_current_alone(display, made) && !refusals.has_any();
    if (is_good)
        return std::make_unique<GlxContext>(display, made, info);
    glXDestroyContext(display, made);
    return nullptr;
}

}  // namespace gpu
