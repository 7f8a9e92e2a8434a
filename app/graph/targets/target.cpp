#include "graph/targets/target.h"

#include "gpu/debug_names.h"

#include <algorithm>
#include <cassert>
#include <utility>

Result<Target> Target::make(const PlannedTarget& planned) {
    Target target;
    target.m_planned = planned;
    const Extent extent = planned.onto || planned.is_unused ? Extent{1, 1} : planned.extent;
    for (int i = planned.common ? 1 : 0; i < planned.slots; ++i) {
        auto canvas = gpu::Canvas::make(extent, planned.format, planned.mipmapped);
        if (!canvas)
            return fail(canvas.error());
        target.m_slots.push_back(std::move(*canvas));
    }
    return target;
}

std::size_t Target::slot_of(int frames_ago) const {
    const std::size_t count = m_slots.size();
    const std::size_t back = std::min(static_cast<std::size_t>(std::max(frames_ago, 0)), count - 1);
    return (m_current + count - back) % count;
}

const gpu::Canvas& Target::canvas(int frames_ago) const {
    if (m_slots.empty() || (m_is_newest_shared && frames_ago <= 0))
        return *m_shared;
    if (m_is_newest_shared)
        return m_slots[slot_of(frames_ago - 1)];
    if (m_unfinished == Unfinished::no)
        return m_slots[slot_of(frames_ago)];
    if (frames_ago <= 0)
        return m_spare ? *m_spare : m_slots[m_current];
    return m_slots[slot_of(m_unfinished == Unfinished::next ? frames_ago - 1 : frames_ago)];
}

gpu::Canvas& Target::canvas(int frames_ago) {
    return const_cast<gpu::Canvas&>(std::as_const(*this).canvas(frames_ago));
}

void Target::advance() {
    if (m_shared)
        m_is_newest_shared = true;
    else if (m_unfinished == Unfinished::next)
        take_spare();
    else
        m_current = (m_current + 1) % m_slots.size();
}

// The unfinished picture becomes the newest. The oldest is overwritten next.
void Target::take_spare() {
    m_current = (m_current + 1) % m_slots.size();
    std::swap(*m_spare, m_slots[m_current]);
}

void Target::release(bool is_drawn) {
    if (!std::exchange(m_is_newest_shared, false) || m_slots.empty() || !is_drawn)
        return;
    m_current = (m_current + 1) % m_slots.size();
    std::swap(*m_shared, m_slots[m_current]);
}

void Target::allocate_unfinished() {
    if (m_unfinished == Unfinished::no || m_spare)
        return;
    const gpu::Texture& texture = m_slots.front().texture();
    if (auto made = gpu::Canvas::make(texture.extent(), m_planned.format, m_planned.mipmapped)) {
        m_spare.emplace(std::move(*made));
        gpu::set_label(*m_spare, m_label);
        return;
    }
    if (std::exchange(m_unfinished, Unfinished::no) == Unfinished::next)
        advance();
}

void Target::finish() {
    const Unfinished finished = std::exchange(m_unfinished, Unfinished::no);
    assert(finished == Unfinished::no || m_spare);
    if (finished == Unfinished::next)
        take_spare();
    else if (finished == Unfinished::again)
        std::swap(*m_spare, m_slots[m_current]);
}

void Target::release_unfinished() {
    drop();
    m_spare.reset();
}

void Target::keep() {
    if (m_slots.size() < 2)
        return;
    canvas(1).copy_to(canvas());
    canvas().texture().generate_mipmaps();
}

void Target::clear() {
    drop();
    m_is_drawn = false;
    for (gpu::Canvas& canvas : m_slots) {
        canvas.clear();
        canvas.texture().generate_mipmaps();
    }
}

void Target::set_label(const std::string& name) {
    m_label = name;
    for (const gpu::Canvas& canvas : m_slots)
        gpu::set_label(canvas, name);
    if (m_spare)
        gpu::set_label(*m_spare, name);
}

void Target::adopt(Target&& old) {
    old.drop();
    m_is_drawn = old.m_is_drawn;
    const int count = static_cast<int>(std::min(m_slots.size(), old.m_slots.size()));
    for (int ago = 0; ago < count; ++ago)
        canvas(ago) = std::move(old.canvas(ago));
}

void Target::adopt_stretched(Target& old) {
    old.drop();
    m_is_drawn = old.m_is_drawn;
    const int count = static_cast<int>(std::min(m_slots.size(), old.m_slots.size()));
    for (int ago = 0; ago < count; ++ago) {
        old.canvas(ago).stretch_to(canvas(ago));
        canvas(ago).texture().generate_mipmaps();
    }
}

bool is_compatible(const PlannedTarget& a, const PlannedTarget& b) {
    return a.onto.has_value() == b.onto.has_value() && a.is_unused == b.is_unused &&
           a.extent == b.extent && a.format == b.format && a.mipmapped == b.mipmapped;
}
