#pragma once

#include "graph/inspect/light_cells.h"
#include "model/picture/subframe_cells.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

/// Counts flashes of the picture. The cells of each frame are read back later. Sub-frames count as
/// the mean of their source frame.
class FlashMeter {
public:
    explicit FlashMeter(LightCells cells) : m_cells(std::move(cells)) {}

    /// A displayed frame; `number` changes whenever the picture may have changed.
    struct DisplayedFrame {
        const gpu::Texture& picture;
        Encoding encoding;
        std::uint64_t number;
        Subframe subframe = {};
    };
    /// Call it after a frame with the time of its display. A static picture is only measured until
    /// its flashes have expired. Never waits for the GPU.
    void update(const DisplayedFrame& frame, double seconds);
    /// Discards all measurements; call it when nothing is displayed.
    void stop();

    /// Within the last second.
    const Flashes& flashes() const { return m_flashes; }
    /// Whether frames are still pending, or flashes have not expired.
    bool is_counting() const { return !m_coming.empty() || m_flashes != Flashes{}; }

private:
    struct Coming {
        double seconds = 0.0;
        Subframe subframe;
        gpu::Download cells;
    };
    LightCells m_cells;
    std::deque<Coming> m_coming;
    SubframeCells m_subframes;
    FlashCounter m_counter;
    Flashes m_flashes;
    std::optional<std::uint64_t> m_number;  // of the picture measured last
};
