#include "graph/executor/separate_pictures.h"

#include <utility>

void SeparatePictures::begin_frame(bool draws_onto, std::uint64_t number) {
    m_frames += draws_onto ? 1 : 0;
    std::erase_if(m_pictures, [&](const auto& one) {
        constexpr std::uint64_t pictures = 600;  // without a request
        return one.second.asked + pictures < number;
    });
}

SeparatePictures::Found SeparatePictures::take(std::size_t pass, const PlannedTarget& planned,
                                               std::uint64_t number) {
    if (m_frames == 0)
        return {};
    auto found = m_pictures.find(pass);
    if (found == m_pictures.end()) {
        auto canvas = gpu::Canvas::make(planned.extent, planned.format);
        if (!canvas)
            return {};
        found = m_pictures.emplace(pass, Separate{std::move(*canvas)}).first;
    }
    Separate& separate = found->second;
    separate.asked = number;
    const bool is_stale = std::exchange(separate.drawn, m_frames) != m_frames;
    return {&separate.canvas, is_stale};
}
