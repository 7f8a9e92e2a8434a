#include "graph/targets/flipped_rows.h"

#include "gpu/objects/draw.h"

namespace {
constexpr std::uint64_t max_pictures_unseen = 120;
}  // namespace

bool FlippedRows::holds(const gpu::Texture& stored, std::uint64_t number) const {
    const auto found = m_copies.find(stored.handle());
    return found != m_copies.end() && found->second.number == number;
}

FlippedRows::Copy* FlippedRows::copy_for(const gpu::Texture& stored, std::uint64_t number) {
    const auto found = m_copies.find(stored.handle());
    if (found != m_copies.end() && found->second.canvas.texture().extent() == stored.extent() &&
        found->second.canvas.texture().format() == stored.format())
        return &found->second;
    std::erase_if(m_copies, [&](const auto& entry) {
        return entry.first == stored.handle() || entry.second.number + max_pictures_unseen < number;
    });
    auto canvas = gpu::Canvas::make(stored.extent(), stored.format(), stored.is_mipmapped());
    if (!canvas)
        return nullptr;
    return &m_copies.emplace(stored.handle(), Copy{std::move(*canvas), number - 1}).first->second;
}

// Without memory for a copy, the picture is displayed upside down.
const gpu::Texture& FlippedRows::view(const gpu::Texture& stored, RowOrder rows,
                                      std::uint64_t number) {
    if (rows == RowOrder::bottom_first)
        return stored;
    if (!m_pass_through) {
        auto made = PassThrough::make();
        if (!made)
            return stored;
        m_pass_through.emplace(std::move(*made));
    }
    Copy* copy = copy_for(stored, number);
    if (!copy)
        return stored;
    if (copy->number != number) {
        const gpu::DrawScope scope;
        m_pass_through->draw(stored, {Filter::nearest, Wrap::edge, false}, copy->canvas, m_samplers,
                             true);
        m_samplers.release();
        copy->canvas.texture().generate_mipmaps();
        copy->number = number;
    }
    return copy->canvas.texture();
}
