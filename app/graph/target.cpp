#include "graph/target.h"

#include <algorithm>

Result<Target> Target::make(const PlannedTarget& planned) {
    Target target;
    target.m_planned = planned;
    for (int i = 0; i < planned.slots; ++i) {
        auto canvas = gpu::Canvas::make(planned.extent, planned.format, planned.mipmapped);
        if (!canvas)
            return fail(canvas.error());
        target.m_slots.push_back(std::move(*canvas));
    }
    return target;
}

std::size_t Target::place_of(int frames_ago) const {
    const std::size_t count = m_slots.size();
    const std::size_t back = std::min(static_cast<std::size_t>(std::max(frames_ago, 0)), count - 1);
    return (m_current + count - back) % count;
}

void Target::advance() {
    m_current = (m_current + 1) % m_slots.size();
}

void Target::keep() {
    if (m_slots.size() < 2)
        return;
    canvas(1).copy_to(canvas());
    canvas().texture().generate_mipmaps();
}

void Target::clear() {
    m_is_drawn = false;
    for (gpu::Canvas& canvas : m_slots) {
        canvas.clear();
        canvas.texture().generate_mipmaps();
    }
}

void Target::adopt(Target&& former) {
    m_is_drawn = former.m_is_drawn;
    const int count = std::min(m_planned.slots, former.m_planned.slots);
    for (int ago = 0; ago < count; ++ago)
        canvas(ago) = std::move(former.canvas(ago));
}

bool is_compatible(const PlannedTarget& a, const PlannedTarget& b) {
    return a.extent == b.extent && a.format == b.format && a.mipmapped == b.mipmapped;
}
