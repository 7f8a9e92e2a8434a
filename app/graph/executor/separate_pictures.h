#pragma once

#include "gpu/objects/canvas.h"
#include "model/plan/plan.h"

#include <cstddef>
#include <cstdint>
#include <map>

/// Pictures of single passes that are drawn onto the target of another pass. They are drawn only
/// when something displays the pass.
class SeparatePictures {
public:
    /// Call at the start of a frame. `draws_onto`: it draws such passes. `number` identifies the
    /// pictures of the executor. Pictures that nothing displays any more are freed.
    void begin_frame(bool draws_onto, std::uint64_t number);
    void clear() { m_pictures.clear(); }

    struct Found {
        const gpu::Canvas* canvas = nullptr;  // null: before the first frame, and without memory
        bool is_stale = false;                // to be drawn again
    };
    /// For displaying the pass. The caller draws a stale picture.
    Found take(std::size_t pass, const PlannedTarget& planned, std::uint64_t number);

private:
    struct Separate {
        gpu::Canvas canvas;
        std::uint64_t drawn = 0;  // m_frames at its draw
        std::uint64_t asked = 0;  // number at the last request
    };

    std::map<std::size_t, Separate> m_pictures;
    std::uint64_t m_frames = 0;  // with passes drawn onto others
};
