#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "graph/programs/sample_programs.h"

#include <memory>
#include <utility>
#include <vector>

/// The programs of a PassThrough, by the kind of numbers that they write.
using PassThroughPrograms = std::vector<SamplePrograms>;
Result<PassThroughPrograms> build_pass_through();

/// Copies a texture to the whole of a target of any size and format, as a bypassed pass does.
/// Numbers keep their values. Integer targets truncate floats and clamp numbers that are out of
/// range.
class PassThrough {
public:
    /// Builds its own programs.
    static Result<PassThrough> make();
    explicit PassThrough(std::shared_ptr<const PassThroughPrograms> programs)
        : m_programs(std::move(programs)) {}

    /// Call in a gpu::DrawScope. `is_flipped` reverses the order of the rows.
    void draw(const gpu::Texture& from, const Sampler& sampler, const gpu::Canvas& to,
              gpu::Samplers& samplers, bool is_flipped = false) const;

private:
    std::shared_ptr<const PassThroughPrograms> m_programs;  // shared within a context
    gpu::VertexArray m_vertices;
};
