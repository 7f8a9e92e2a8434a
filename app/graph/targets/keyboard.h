#pragma once

#include "gpu/objects/texture.h"
#include "model/devices/input_state.h"
#include "model/look/look.h"

#include <optional>

/// The keyboard as a texture: 256 columns, one per key, and three rows. From v = 0: held, pressed
/// since the previous frame, toggled. All channels are 1 or 0.
class Keyboard {
public:
    /// Creates the texture if the look reads it.
    Result<void> prepare(const Look& look);
    void show(const Keys& keys);
    /// Null if no look reads it.
    const gpu::Texture* texture() const { return m_texture ? &*m_texture : nullptr; }

private:
    void upload();

    std::optional<gpu::Texture> m_texture;
    Keys m_shown;
};
