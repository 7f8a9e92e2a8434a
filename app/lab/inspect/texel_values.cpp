#include "lab/inspect/texel_values.h"

#include "graph/inspect/displayed_luminance.h"

#include <algorithm>
#include <cmath>

namespace {
struct Span {
    int first = 0;
    int count = 0;
};

// The visible texels in one direction. The first texel starts at `start` px; each is `length` px.
Span seen_texels(double start, double length, int texels, int view) {
    const int first = std::max(0, static_cast<int>(std::floor(-start / length)));
    const int end = std::min(texels, static_cast<int>(std::ceil((view - start) / length)));
    return {first, std::max(end - first, 0)};
}

TexelValues::Placement sight_of(const TexelValues::Subject& subject) {
    const Extent own = subject.texture.extent();
    return {.left = subject.position.left,
            .top = subject.position.top,
            .texel_width = subject.position.zoom * subject.whole.width / own.width,
            .texel_height = subject.position.zoom * subject.whole.height / own.height,
            .format = subject.texture.format(),
            .options = subject.options};
}

bool is_same_position(const TexelValues::Block& a, const TexelValues::Block& b) {
    return a.left == b.left && a.top == b.top && a.count == b.count;
}
}  // namespace

TexelValues::Block visible_cells(const TexelValues::Subject& subject) {
    const Extent own = subject.texture.extent();
    const TexelValues::Placement placement = sight_of(subject);
    if (subject.minimum.is_empty() || placement.texel_width < subject.minimum.width ||
        placement.texel_height < subject.minimum.height)
        return {};
    const Span x =
        seen_texels(placement.left, placement.texel_width, own.width, subject.size.width);
    const Span y =
        seen_texels(placement.top, placement.texel_height, own.height, subject.size.height);
    return {x.first, y.first, {x.count, y.count}, {}};
}

bool TexelValues::is_light(std::size_t texel) const {
    // At this luminance, the contrast to black and white text is equal: 4.6 to 1 (WCAG 2.1).
    constexpr double between = 0.179;
    return displayed_luminance(m_block.numbers[texel], m_placement.format, m_placement.options) >
           between;
}

void TexelValues::stop() {
    m_readback.stop();
    m_name.clear();
    m_block = {};
    m_asked = {};
    m_is_late = false;
}

void TexelValues::update(TexelReader& reader, const Subject& subject, double seconds) {
    constexpr double pause_seconds = 0.2;
    Block visible = visible_cells(subject);
    if (visible.count.is_empty())
        return stop();
    if (subject.name != m_name) {
        stop();  // discard numbers of another texture
        m_name = subject.name;
    }
    m_placement = sight_of(subject);
    if (auto numbers = m_readback.take()) {
        m_block = m_asked;
        m_block.numbers = std::move(*numbers);
    }
    const bool is_moved = !is_same_position(visible, m_asked);
    m_is_late = is_moved || m_picture != subject.picture;
    if (m_readback.is_busy() || !m_is_late || (!is_moved && seconds < m_due))
        return;
    m_readback.ask(
        reader, subject.texture,
        {.count = visible.count,
         .first = {static_cast<double>(visible.left), static_cast<double>(visible.top)}});
    m_asked = std::move(visible);
    m_picture = subject.picture;
    m_due = seconds + pause_seconds;
    m_is_late = false;
}
