#pragma once

#include "graph/inspect/texel_reader.h"
#include "graph/inspect/viewer.h"
#include "lab/window/window_state.h"

#include <cstdint>
#include <string>
#include <vector>

/// The stored numbers of the texels of a view that shows each of them so large that they can be
/// written into it. Fetched at most five times a second while nothing is moved.
class CellNumbers {
public:
    struct Subject {
        const gpu::Texture& texture;
        std::string name;  // of what the texture holds
        Extent whole;      // px that it is seen as
        PicturePlace place;
        Extent size;                // of the view
        Extent least;               // device pixels that a texel needs for its numbers; empty: none
        std::uint64_t picture = 0;  // Executor::picture_number
        ViewOptions options = {};
    };
    /// To be called every turn while the view is shown; never waits for the GPU.
    void update(TexelReader& reader, const Subject& subject, double seconds);
    /// Nobody looks any more.
    void stop();

    /// Texels from the top left one on, row by row.
    struct Block {
        int left = 0;  // texels
        int top = 0;
        Extent count;
        std::vector<std::array<float, 4>> numbers;
    };
    /// Null where texels are too small, or nothing has come yet.
    const Block* block() const { return m_block.numbers.empty() ? nullptr : &m_block; }
    /// Where its texels lie in the view and how they are seen, as of the last update.
    struct Sight {
        double left = 0.0;  // device pixels, of the texture's corner
        double top = 0.0;
        double texel_width = 0.0;
        double texel_height = 0.0;
        Format format = Format::rgba8;
        ViewOptions options;
    };
    const Sight& sight() const { return m_sight; }
    /// Whether black is read better than white on a texel of the block as it is seen.
    bool is_light(std::size_t texel) const;
    /// Some have not come yet.
    bool is_owing() const { return m_answer.is_busy() || m_is_late; }

private:
    TexelAnswer m_answer;
    std::string m_name;
    Block m_asked;  // its numbers are under way
    Block m_block;
    Sight m_sight;
    std::uint64_t m_picture = 0;
    double m_due = 0.0;      // s
    bool m_is_late = false;  // they are of a former picture
};

/// The texels that can be seen in the view; no count where they are too small.
CellNumbers::Block seen_cells(const CellNumbers::Subject& subject);
