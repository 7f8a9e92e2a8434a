#pragma once

#include "gpu/objects/download.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "graph/programs/sample_programs.h"

#include <array>
#include <optional>
#include <vector>

/// Texels that lie evenly: a block of them, or those along a line. Places are in texels from the
/// top left corner of a texture, and mean the texel that they lie in.
struct TexelRows {
    Extent count;                        // in a row, and rows
    std::array<double, 2> first{};       // x, y
    std::array<double, 2> across{1, 0};  // from one to the next of its row
    std::array<double, 2> down{0, 1};    // from row to row

    bool operator==(const TexelRows&) const = default;
};

/// Draws the stored numbers of such texels, of any texture, into a canvas of floats.
class TexelReader {
public:
    static Result<TexelReader> make();

    /// RGBA from the bottom row of the canvas on; channels that a format lacks are 0, alpha 1. What
    /// lies outside is read at the edge. False where there is no memory.
    bool draw(const gpu::Texture& from, const TexelRows& rows, std::optional<gpu::Canvas>& to);

private:
    explicit TexelReader(SamplePrograms programs) : m_programs(std::move(programs)) {}

    SamplePrograms m_programs;
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
};

/// Numbers of texels on their way here: nobody waits, they come in a later frame.
class TexelAnswer {
public:
    bool is_busy() const { return m_to_come.has_value(); }
    /// What was under way is dropped.
    void ask(TexelReader& reader, const gpu::Texture& from, const TexelRows& rows);
    /// RGBA, row by row, once, when they have come.
    std::optional<std::vector<std::array<float, 4>>> take();
    void stop() { m_to_come.reset(); }

private:
    std::optional<gpu::Canvas> m_canvas;
    std::optional<gpu::Download> m_to_come;
};
