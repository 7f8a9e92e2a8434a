#include "lab/inspect/thumbnails.h"

#include <algorithm>

namespace {
Extent small_extent(Extent whole, int height) {
    const int width =
        std::clamp(height * whole.width / std::max(whole.height, 1), height / 2, height * 5 / 2);
    return {std::max(width, 1), height};
}
}  // namespace

void Thumbnails::stop() {
    *this = {};
}

void Thumbnails::update(Viewer& viewer, const Executor& executor, const Values& values, int height,
                        double seconds) {
    if (height <= 0)
        return stop();
    m_seconds = seconds;
    const std::vector<std::string> passes = pass_names(executor.look());
    if (m_passes != passes || m_height != height) {
        m_pictures.resize(passes.size());  // the previous ones stay until their update
        m_passes = passes;
        m_height = height;
        m_round_robin.restart(passes.size());
        m_outdated_at.resize(passes.size());
    }
    follow_values(values, executor.textures().number());
    const auto pass = m_round_robin.due(executor.textures().number(), seconds);
    if (!pass)
        return;
    draw(viewer, executor, *pass);
    m_outdated_at[*pass].reset();
    m_round_robin.done(seconds);
}

// A change of values without a new picture leaves the thumbnails as they are.
void Thumbnails::follow_values(const Values& values, std::uint64_t picture) {
    if (m_values != values) {
        m_values = values;
        m_has_other_values = true;
    }
    if (m_has_other_values && picture != m_number) {
        m_has_other_values = false;
        for (auto& outdated_at : m_outdated_at)
            outdated_at = outdated_at.value_or(m_seconds);
    }
    m_number = picture;
}

// Without memory the thumbnail stays empty, because the passes need the memory.
void Thumbnails::draw(Viewer& viewer, const Executor& executor, std::size_t pass) {
    const int index = static_cast<int>(pass);
    const gpu::Texture& target = executor.target(index);
    const Extent small = small_extent(target.extent(), m_height);
    auto canvas = gpu::Canvas::make(small, Format::rgba8);
    if (!canvas)
        return m_pictures[pass].reset();
    viewer.draw(target, *canvas, {.encoding = encoding_of(executor.look(), index)});
    m_pictures[pass] = std::move(*canvas).take_texture();
}

bool Thumbnails::is_stale(std::size_t pass) const {
    constexpr double delay_seconds = 0.5;
    return pass < m_outdated_at.size() && m_outdated_at[pass] &&
           m_seconds - *m_outdated_at[pass] >= delay_seconds;
}

const gpu::Texture* Thumbnails::picture(std::size_t pass) const {
    return pass < m_pictures.size() && m_pictures[pass] ? &*m_pictures[pass] : nullptr;
}
