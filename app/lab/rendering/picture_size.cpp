#include "lab/rendering/picture_size.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr double min_picture_scale = 0.25;
constexpr double largest_picture_scale = 2.0;
}  // namespace

Extent PictureSize::scaled(Extent extent) const {
    const auto side = [this](int length) {
        return std::clamp(static_cast<int>(std::lround(length * scale)), 1, 16384);
    };
    return {side(extent.width), side(extent.height)};
}

std::optional<PictureSize> PictureSize::halved() const {
    PictureSize half = *this;
    half.scale *= 0.5;
    return half.scale >= min_picture_scale ? std::optional(half) : std::nullopt;
}

PictureSize fixed_in(const PictureSize& size, Extent view) {
    return {.fixed = view, .scale = size.scale, .fits_shape = true};
}

PictureSize within_bounds(PictureSize size) {
    size.scale = std::clamp(size.scale, min_picture_scale, largest_picture_scale);
    return size;
}
