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

void Thumbnails::update(Viewer& viewer, const Executor& executor, int height, double seconds) {
    if (height <= 0)
        return stop();
    const std::vector<std::string> passes = pass_names(executor.look());
    if (m_passes != passes || m_height != height) {
        m_pictures.resize(passes.size());  // the previous ones stay until their update
        m_passes = passes;
        m_height = height;
        m_round_robin.restart(passes.size());
    }
    const auto pass = m_round_robin.due(executor.textures().number(), seconds);
    if (!pass)
        return;
    draw(viewer, executor, *pass);
    m_round_robin.done(seconds);
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

const gpu::Texture* Thumbnails::picture(std::size_t pass) const {
    return pass < m_pictures.size() && m_pictures[pass] ? &*m_pictures[pass] : nullptr;
}
