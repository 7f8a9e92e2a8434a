#pragma once

#include "gpu/objects/buffer.h"
#include "gpu/objects/canvas.h"

#include <memory>
#include <type_traits>
#include <vector>

namespace gpu {

struct DeleteFence {
    void operator()(GLsync fence) const;
};

/// The texels of a canvas on their way here: asked for in one frame, they come in a later one, so
/// that nobody waits for the GPU. The canvas may be drawn into again at once.
class Download {
public:
    /// All of a canvas that does not hold whole numbers.
    explicit Download(const Canvas& from);

    bool has_come() const;
    /// RGBA, the bottom row first. Waits where they have not come.
    std::vector<float> take();

private:
    std::size_t m_count;  // of floats
    Name<delete_buffer> m_buffer;
    std::unique_ptr<std::remove_pointer_t<GLsync>, DeleteFence> m_fence;
};

}  // namespace gpu
