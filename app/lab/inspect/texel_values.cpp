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

CellNumbers::Sight sight_of(const CellNumbers::Subject& subject) {
    const Extent own = subject.texture.extent();
    return {.left = subject.position.left,
            .top = subject.position.top,
            .texel_width = subject.position.zoom * subject.whole.width / own.width,
            .texel_height = subject.position.zoom * subject.whole.height / own.height,
            .format = subject.texture.format(),
            .options = subject.options};
}

bool is_same_position(const CellNumbers::Block& a, const CellNumbers::Block& b) {
    return a.left == b.left && a.top == b.top && a.count == b.count;
}
}  // namespace

CellNumbers::Block seen_cells(const CellNumbers::Subject& subject) {
    const Extent own = subject.texture.extent();
    const CellNumbers::Sight sight = sight_of(subject);
    if (subject.least.is_empty() || sight.texel_width < subject.least.width ||
        sight.texel_height < subject.least.height)
        return {};
    const Span x = seen_texels(sight.left, sight.texel_width, own.width, subject.size.width);
    const Span y = seen_texels(sight.top, sight.texel_height, own.height, subject.size.height);
    return {x.first, y.first, {x.count, y.count}, {}};
}

bool CellNumbers::is_light(std::size_t texel) const {
    // At this luminance, the contrast to black and white text is equal: 4.6 to 1 (WCAG 2.1).
    constexpr double between = 0.179;
    return displayed_luminance(m_block.numbers[texel], m_sight.format, m_sight.options) > between;
}

void CellNumbers::stop() {
    m_answer.stop();
    m_name.clear();
    m_block = {};
    m_asked = {};
    m_is_late = false;
}

void CellNumbers::update(TexelReader& reader, const Subject& subject, double seconds) {
    constexpr double pause_seconds = 0.2;
    Block visible = seen_cells(subject);
    if (visible.count.is_empty())
        return stop();
    if (subject.name != m_name) {
        stop();  // discard numbers of another texture
        m_name = subject.name;
    }
    m_sight = sight_of(subject);
    if (auto numbers = m_answer.take()) {
        m_block = m_asked;
        m_block.numbers = std::move(*numbers);
    }
    const bool is_moved = !is_same_position(visible, m_asked);
    m_is_late = is_moved || m_picture != subject.picture;
    if (m_answer.is_busy() || !m_is_late || (!is_moved && seconds < m_due))
        return;
    m_answer.ask(reader, subject.texture,
                 {.count = visible.count,
                  .first = {static_cast<double>(visible.left), static_cast<double>(visible.top)}});
    m_asked = std::move(visible);
    m_picture = subject.picture;
    m_due = seconds + pause_seconds;
    m_is_late = false;
}
