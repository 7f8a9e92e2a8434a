#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"
#include "model/look/picture.h"

#include <cstdint>

/// The GPU memory of all images of a look: at most 1 GiB.
class ImageBudget {
public:
    /// Fails before the upload if the image exceeds the limit.
    Result<void> take(const Image& image, const Picture& picture);

private:
    std::int64_t m_bytes = 0;
};
