#pragma once

#include "bench/reload_looks.h"
#include "gpu/context.h"
#include "graph/executor/executor.h"

#include <epoxy/gl.h>

#include <memory>
#include <string>

namespace bench {

/// What a reload of the last pass cannot do without, in a context of its own: glslang's parse, GL's
/// compile and link, and a first draw as large as the picture.
class PlainReload {
public:
    /// Takes the texts that the executor's last pass is drawn with; `look` is what it draws.
    PlainReload(const Executor& of, const ReloadLook& look);
    ~PlainReload();
    PlainReload(const PlainReload&) = delete;
    PlainReload& operator=(const PlainReload&) = delete;

    /// CPU time of the process for a text that has not been before, without that of drawing it a
    /// second time, in milliseconds.
    double over_a_frame(int number);

    /// Wall time until such a text is parsed, compiled and linked, in milliseconds.
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
