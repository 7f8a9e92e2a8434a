#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/texture.h"

#include <cstdint>
#include <optional>

/// A texture for ImGui, row 0 at the bottom; a handle of 0: not drawn yet.
struct ViewImage {
    std::uintptr_t handle = 0;
    Extent extent;
};

inline ViewImage image_of(const gpu::Texture* texture) {
    return texture ? ViewImage{texture->handle(), texture->extent()} : ViewImage{};
}

inline ViewImage image_of(const std::optional<gpu::Canvas>& canvas) {
    return image_of(canvas ? &canvas->texture() : nullptr);
}
