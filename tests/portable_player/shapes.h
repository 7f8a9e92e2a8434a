#pragma once

#include "portable_player/beam.h"
#include "portable_player/program.h"

#include <memory>
#include <optional>
#include <vector>

/// The vertices of all passes: a triangle, a quad, or the beam of a frame.
class Shapes {
public:
    Shapes(const Description& description, const Size& view);

    /// Prepares the vertices of the next pass, in the order of the passes.
    void add_pass(const Pass& pass, const Program& program);
    /// The beam of a frame.
    void advance(double start, double end);
    void draw(std::size_t pass) const;

private:
    struct Vertices {
        GlName<delete_vertex_array> name;
        std::string draw;
    };

    std::unique_ptr<Signal> m_signal;
    std::optional<Beam> m_beam;
    GlName<delete_buffer> m_points;
    GlName<delete_buffer> m_segments;
    GlName<delete_buffer> m_quad;
    std::vector<Vertices> m_passes;
};
