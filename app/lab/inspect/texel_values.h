#pragma once

#include "graph/inspect/texel_reader.h"
#include "graph/inspect/viewer.h"
#include "lab/window/picture_view.h"

#include <cstdint>
#include <string>
#include <vector>

/// The stored values of the visible texels, if a view displays them large enough for text. They are
/// read at most five times a second while the view does not move.
class TexelValues {
public:
    struct Subject {
        const gpu::Texture& texture;
        std::string name;  // of the texture's content
        Extent whole;      // displayed size in px
        PicturePosition position;
        Extent size;                // of the view
        Extent minimum;             // device pixels per texel needed for text; empty: no text
        std::uint64_t picture = 0;  // FrameTextures::number()
        ViewOptions options = {};
    };
    /// Call it in every update while the view is visible. Never waits for the GPU.
    void update(TexelReader& reader, const Subject& subject, double seconds);
    /// Discards all numbers; call it when the view is hidden.
    void stop();

    /// A block of texels from the top left, row by row.
    struct Block {
        int left = 0;  // texels
        int top = 0;
        Extent count;
        std::vector<std::array<float, 4>> numbers;
    };
    /// Null: texels are too small, or the numbers are still pending.
    const Block* block() const { return m_block.numbers.empty() ? nullptr : &m_block; }
    /// The position of the texels in the view and their display, as of the last update.
    struct Placement {
        double left = 0.0;  // device pixels, of the texture's corner
        double top = 0.0;
        double texel_width = 0.0;
        double texel_height = 0.0;
        Format format = Format::rgba8;
        ViewOptions options;
    };
    const Placement& placement() const { return m_placement; }
    /// Whether black text is more readable than white text on a texel of the block.
    bool is_light(std::size_t texel) const;
    /// Whether numbers are still pending.
    bool is_pending() const { return m_readback.is_busy() || m_is_late; }

private:
    TexelReadback m_readback;
    std::string m_name;
    Block m_asked;  // its numbers are being read
    Block m_block;
    Placement m_placement;
    std::uint64_t m_picture = 0;
    double m_due = 0.0;      // s
    bool m_is_late = false;  // the numbers are of a previous picture
};

/// The visible texels of the view; empty if they are too small.
TexelValues::Block visible_cells(const TexelValues::Subject& subject);
