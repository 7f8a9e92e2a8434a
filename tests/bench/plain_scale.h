#pragma once

#include "parity/plain_chain.h"

#include <array>
#include <string>
#include <vector>

namespace bench {

/// A look with many small passes. Each mixes the output of the previous pass with its own previous
/// frame, controlled by its own uniforms.
struct ScaleTexts {
    std::string manifest;                // look.json
    std::vector<std::string> fragments;  // pass0.frag and so on
};

struct ScaleSize {
    int passes = 50;
    int parameters_per_pass = 20;
    int side = 8;  // of a target, px
    const char* format = "rgba8";
    GLenum gl_format = GL_RGBA8;
};

ScaleTexts scale_texts(const ScaleSize& size);
std::string scale_parameter(int pass, int parameter);
double scale_initial(int pass, int parameter);

/// The same passes with only the GL calls that they need.
class PlainScale {
public:
    static Result<PlainScale> make(const ScaleSize& size);

    void set(int pass, int parameter, double value) const;
    void draw(double seconds);
    std::vector<float> picture() const { return m_targets[m_now].back().read(); }

private:
    struct Pass {
        gpu::Program program;
        GLint time;
        std::vector<GLint> parameters;
    };
    explicit PlainScale(const ScaleSize& size);

    std::vector<Pass> m_passes;
    std::array<std::vector<plain::Surface>, 2> m_targets;  // of this frame and of the previous one
    std::size_t m_now = 0;
    gpu::Name<plain::delete_vertex_array_name> m_vertices;
    gpu::Name<plain::delete_sampler_name> m_sampler;
};

}  // namespace bench
