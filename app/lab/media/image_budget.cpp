#include "lab/media/image_budget.h"

#include "model/look/format.h"

Result<void> ImageBudget::take(const Image& image, const Picture& picture) {
    constexpr std::int64_t max_bytes = std::int64_t{1} << 30;
    m_bytes +=
        std::int64_t{picture.extent.width} * picture.extent.height * info_of(image.format).bytes;
    if (m_bytes <= max_bytes)
        return {};
    return fail({image.file, 0,
                 "the image is too large: the limit for all images of a look is 1 GiB. Use smaller "
                 "images."});
}
