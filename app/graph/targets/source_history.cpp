#include "graph/targets/source_history.h"

#include "gpu/objects/texels.h"

#include <algorithm>

void SourceHistory::set_slots(int slots) {
    const auto count = static_cast<std::size_t>(slots);
    m_frames.resize(count, none);
    m_textures.resize(std::max(m_textures.size(), count > 1 ? count + 1 : 1));
}

int SourceHistory::free_slot() const {
    int slot = 0;
    if (m_frames.size() > 1)
        while (std::ranges::find(m_frames, slot) != m_frames.end())
            ++slot;
    return slot;
}

Result<void> SourceHistory::set(const Picture& picture, const SourceForm& form) {
    if (picture.extent.is_empty())
        return fail({{}, 0, "the source picture is empty"});
    const int slot = free_slot();
    auto& texture = m_textures[static_cast<std::size_t>(slot)];
    if (!texture || texture->extent() != picture.extent || texture->format() != form.format ||
        texture->is_mipmapped() != form.is_mipmapped) {
        auto made = gpu::Texture::make(picture.extent, form.format, form.is_mipmapped);
        if (!made)
            return fail(made.error());
        texture = std::move(*made);
    }
    gpu::upload_picture(*texture, picture, form.encoding, m_texels, form.rows);
    texture->generate_mipmaps();
    m_newest = slot;
    return {};
}

void SourceHistory::advance() {
    std::shift_right(m_frames.begin(), m_frames.end(), 1);
    m_frames.front() = m_newest;
}

void SourceHistory::clear() {
    std::ranges::fill(m_frames, none);
}

const gpu::Texture* SourceHistory::texture(int frames_ago) const {
    const auto ago = std::min(static_cast<std::size_t>(frames_ago), m_frames.size() - 1);
    const int slot = frames_ago == 0 ? m_newest : m_frames[ago];
    return slot == none ? nullptr : &*m_textures[static_cast<std::size_t>(slot)];
}
