#pragma once

#include "graph/executor/frame_textures.h"
#include "graph/executor/pass_programs.h"
#include "graph/programs/frame.h"
#include "graph/programs/pass_report.h"
#include "graph/targets/pass_through.h"

#include <optional>

/// Draws single passes of the current frame. Passes are given by their index in the look.
class PassDrawer {
public:
    /// All must outlive it.
    PassDrawer(const FrameGraph& graph, const Shapes& shapes, PassPrograms& programs,
               FrameTextures& textures)
        : m_graph(graph), m_shapes(shapes), m_programs(programs), m_textures(textures) {}

    /// Call before a bypassed pass is drawn.
    Result<void> prepare_bypass();

    /// Sets the frame. Its beam and sound are not kept.
    void set_frame(const Frame& frame);
    const Frame& frame() const { return m_frame; }

    /// Uses the program of the pass, with the built-in uniforms of the frame.
    void use(std::size_t pass) const;
    /// Initialises the target: with the picture so far, or the neutral colour of the blending.
    void start_target(std::size_t pass, bool keeps_picture);
    /// Binds the target and the inputs.
    void bind(std::size_t pass);
    /// Draws with the number of samples so far.
    void draw(std::size_t pass, int samples) const;
    /// Copies the input of a bypassed pass to its target.
    void pass_through(std::size_t pass);
    /// Draws a pass that shares a target onto a canvas of its own.
    void draw_separately(std::size_t pass, const gpu::Canvas& canvas, int samples) const;

    /// The inputs and built-in uniforms of the pass, as its generic program reads them.
    PassReport report(std::size_t pass, int samples) const;

private:
    const Frame& frame_of(std::size_t pass) const;
    PassInfo info_of_pass(std::size_t pass) const;
    void draw_shape(std::size_t pass) const;

    const FrameGraph& m_graph;
    const Shapes& m_shapes;
    PassPrograms& m_programs;
    FrameTextures& m_textures;
    std::optional<PassThrough> m_pass_through;  // since the first bypass
    Frame m_frame;                              // the current or last one
    Frame m_source_frame;                       // the same for passes per source frame
};
