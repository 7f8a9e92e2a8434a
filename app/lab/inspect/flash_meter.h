#pragma once

#include "graph/inspect/light_cells.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

/// How often the picture flashes: its cells of every frame, counted when they have come.
class FlashMeter {
public:
    explicit FlashMeter(LightCells cells) : m_cells(std::move(cells)) {}

    /// A frame; another `number` whenever it may be another picture.
    struct Seen {
        const gpu::Texture& picture;
        Encoding encoding;
        std::uint64_t number;
    };
    /// To be called after a frame, with the time at which it is seen. A picture that rests is
    /// looked at again only until its flashes are forgotten. Never waits for the GPU.
    void update(const Seen& seen, double seconds);
    /// Nobody looks any more.
    void stop();

    /// Within the last second.
    const Flashes& flashes() const { return m_flashes; }
    /// Whether frames are yet to be looked at, or a flash is yet to be forgotten.
    bool is_counting() const { return !m_coming.empty() || m_flashes != Flashes{}; }

private:
    struct Coming {
        double seconds = 0.0;
        gpu::Download cells;
    };
    LightCells m_cells;
    std::deque<Coming> m_coming;
    FlashCounter m_counter;
    Flashes m_flashes;
    std::optional<std::uint64_t> m_number;  // of the picture that was looked at last
};
