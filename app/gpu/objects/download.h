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

/// Asynchronous readback of a canvas: requested in one frame and available in a later one, without
/// waiting for the GPU. The canvas may be drawn into again immediately.
class Download {
public:
    /// The whole canvas, which must not have an integer format.
    explicit Download(const Canvas& from);

    bool is_available() const;
    /// RGBA, bottom row first. Waits if the texels are not available yet.
    std::vector<float> take();

private:
    std::size_t m_count;  // number of floats
    Name<delete_buffer> m_buffer;
    std::unique_ptr<std::remove_pointer_t<GLsync>, DeleteFence> m_fence;
};

}  // namespace gpu
