#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"
#include "model/look/picture.h"

#include <cstdint>

/// What the images of one look take on the GPU together: at most 1 GiB.
class ImageBudget {
public:
    /// Refuses the image that is too much, before it is uploaded.
    Result<void> take(const Image& image, const Picture& picture);

private:
    std::int64_t m_bytes = 0;
};
