#pragma once

#include "gpu/objects/texture.h"
#include "model/devices/hand.h"
#include "model/look/look.h"

#include <optional>

/// The keys of a keyboard as a texture: 256 columns, one a key, and three rows, from v = 0: which
/// are down, which went down since the frame before, which are toggled. 1 in all channels, or 0.
class Keyboard {
public:
    /// Makes the texture where the look reads it.
    Result<void> prepare(const Look& look);
    void show(const Keys& keys);
    /// Null where no look reads it.
    const gpu::Texture* texture() const { return m_texture ? &*m_texture : nullptr; }

private:
    void upload();

    std::optional<gpu::Texture> m_texture;
    Keys m_shown;
};
