#pragma once

#include "gpu/objects/download.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "graph/programs/sample_programs.h"

#include <array>
#include <optional>
#include <vector>

/// Evenly spaced texels: a block, or those along a line. Positions are in texels from the top left
/// corner of a texture and refer to the texel that contains them.
struct TexelRows {
    Extent count;                        // texels per row, number of rows
    std::array<double, 2> first{};       // x, y
    std::array<double, 2> across{1, 0};  // step to the next texel of the row
    std::array<double, 2> down{0, 1};    // step to the next row

    bool operator==(const TexelRows&) const = default;
};

/// Draws the stored numbers of such texels of any texture into a float canvas.
class TexelReader {
public:
    static Result<TexelReader> make();

    /// RGBA, starting at the bottom row of the canvas. Channels that a format lacks are 0, alpha 1.
    /// Texels outside the texture are clamped to its edge. False without memory.
    bool draw(const gpu::Texture& from, const TexelRows& rows, std::optional<gpu::Canvas>& to);

private:
    explicit TexelReader(SamplePrograms programs) : m_programs(std::move(programs)) {}

    SamplePrograms m_programs;
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
};

/// An asynchronous readback of texels: the numbers are available in a later frame.
class TexelReadback {
public:
    bool is_busy() const { return m_to_come.has_value(); }
    /// Starts a request and drops a pending one.
    void ask(TexelReader& reader, const gpu::Texture& from, const TexelRows& rows);
    /// RGBA, row by row, once, when available.
    std::optional<std::vector<std::array<float, 4>>> take();
    void stop() { m_to_come.reset(); }

private:
    std::optional<gpu::Canvas> m_canvas;
    std::optional<gpu::Download> m_to_come;
};
