#pragma once

#include "bench/reload_looks.h"
#include "gpu/context.h"
#include "graph/executor/executor.h"

#include <epoxy/gl.h>

#include <memory>
#include <string>

namespace bench {

/// The minimum for a reload of the last pass, in its own context: parse with glslang, compile and
/// link with GL, draw once at the size of the picture.
class PlainReload {
public:
    /// Uses the texts of the executor's last pass; `look` is the look that it draws.
    PlainReload(const Executor& of, const ReloadLook& look);
    ~PlainReload();
    PlainReload(const PlainReload&) = delete;
    PlainReload& operator=(const PlainReload&) = delete;

    /// CPU time of the process in milliseconds for a new text, minus that of drawing it a second
    /// time.
    double over_a_frame(int number);

    /// Wall time in milliseconds until a new text is parsed, compiled and linked.
    double until_linked(int number);

private:
    GLuint build(const std::string& fragment) const;
    void use(GLuint program) const;

    const ReloadLook& m_look;
    std::unique_ptr<gpu::Context> m_context;
    std::string m_vertex;
    std::string m_fragment;
    Extent m_picture;
    GLuint m_target = 0;
    GLuint m_framebuffer = 0;
    GLuint m_vertices = 0;
    GLuint m_inputs[8] = {};
};

}  // namespace bench
