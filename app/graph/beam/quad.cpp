#include "graph/beam/quad.h"

#include <array>

Quad::Quad() {
    constexpr std::array<float, 8> corners{0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 1.0f, 1.0f, 1.0f};
    m_corners.write(std::as_bytes(std::span(corners)));
}

gpu::VertexArray Quad::vertices() const {
    constexpr int stride = 2 * sizeof(float);
    gpu::VertexArray vertices;
    for (const int location : {0, 1})
        vertices.set({location, 2, stride, 0, false}, m_corners);
    return vertices;
}
