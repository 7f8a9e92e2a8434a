#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "graph/programs/sample_programs.h"

#include <memory>
#include <utility>
#include <vector>

/// What PassThroughs draw with: into each kind of numbers.
using PassThroughPrograms = std::vector<SamplePrograms>;
Result<PassThroughPrograms> build_pass_through();

/// Draws what a texture holds over the whole of a target of any size and format: what a bypassed
/// pass does. Numbers stay as they are; of lights an integer target takes the whole part, and of
/// numbers that it has none of the nearest.
class PassThrough {
public:
    /// With programs of its own.
    static Result<PassThrough> make();
    explicit PassThrough(std::shared_ptr<const PassThroughPrograms> programs)
        : m_programs(std::move(programs)) {}

    /// Within a gpu::DrawScope. Flipped, the first row of the one is the last of the other.
    void draw(const gpu::Texture& from, const Sampler& sampler, const gpu::Canvas& to,
              gpu::Samplers& samplers, bool is_flipped = false) const;

private:
    std::shared_ptr<const PassThroughPrograms> m_programs;  // of who draws in the same context
    gpu::VertexArray m_vertices;
};
