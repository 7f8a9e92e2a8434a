#pragma once

#include "graph/targets/pass_through.h"
#include "model/look/picture.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

/// Pictures whose top row comes first, turned over for those who look at them. Each is turned when
/// it is first looked at after it may have changed, and forgotten when nobody does.
class Upright {
public:
    /// The texture itself where its bottom row comes first. `number` is another one whenever the
    /// texture may hold something else. Draws; valid until the next call but one with another
    /// number.
    const gpu::Texture& view(const gpu::Texture& stored, RowOrder rows, std::uint64_t number);
    /// Whether view() needs not draw.
    bool holds(const gpu::Texture& stored, std::uint64_t number) const;
    void forget() { m_copies.clear(); }
    /// Without it, it makes programs of its own when it needs them.
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
    std::map<std::uintptr_t, Copy> m_copies;  // by the handle of what they are of
};
