#include "graph/targets/keyboard.h"

#include <algorithm>
#include <array>

Result<void> Keyboard::prepare(const Look& look) {
    const bool is_read = std::ranges::any_of(look.passes, [](const Pass& pass) {
        return std::ranges::find(pass.inputs, Input::From::keyboard, &Input::from) !=
               pass.inputs.end();
    });
    if (!is_read || m_texture)
        return {};
    auto made = gpu::Texture::make({static_cast<int>(Keys::count), 3}, Format::rgba8);
    if (!made)
        return fail(made.error());
    m_texture = std::move(*made);
    upload();
    return {};
}

void Keyboard::show(const Keys& keys) {
    if (!m_texture || keys == m_shown)
        return;
    m_shown = keys;
    upload();
}

void Keyboard::upload() {
    std::vector<float> texels;
    for (const Keys::Flags& row : {m_shown.down, m_shown.pressed, m_shown.toggled})
        for (std::size_t key = 0; key < Keys::count; ++key)
            texels.insert(texels.end(), 4, row[key] ? 1.0f : 0.0f);
    m_texture->upload(texels);
}
