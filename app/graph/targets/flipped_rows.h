#pragma once

#include "graph/targets/pass_through.h"
#include "model/look/picture.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

/// Flipped copies, for display, of pictures that store the top row first. A copy is drawn on first
/// use after the picture may have changed. It is removed if it is not used for some time.
class FlippedRows {
public:
    /// The texture itself if its bottom row comes first. `number` changes whenever the texture may
    /// have changed. May draw. The result is valid until the second call with another number.
    const gpu::Texture& view(const gpu::Texture& stored, RowOrder rows, std::uint64_t number);
    /// Whether view() would not draw.
    bool holds(const gpu::Texture& stored, std::uint64_t number) const;
    void forget() { m_copies.clear(); }
    /// Sets shared programs. Otherwise it builds its own on first use.
    void draw_with(std::shared_ptr<const PassThroughPrograms> programs) {
        m_pass_through.emplace(std::move(programs));
    }

private:
    struct Copy {
        gpu::Canvas canvas;
        std::uint64_t number;
    };

    Copy* copy_for(const gpu::Texture& stored, std::uint64_t number);

    std::optional<PassThrough> m_pass_through;
    gpu::Samplers m_samplers;
    std::map<std::uintptr_t, Copy> m_copies;  // by the handle of the original
};
