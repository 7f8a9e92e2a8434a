#include "graph/warm_up/first_views.h"

#include "gpu/objects/canvas.h"
#include "gpu/objects/draw.h"
#include "graph/warm_up/power_of_two.h"

#include <algorithm>

namespace {
constexpr Extent view_extent{24, 24};  // smaller than the warm-up pictures

int small_side(bool has_power_of_two) {
    return has_power_of_two ? 64 : 96;
}
}  // namespace

FirstViews::FirstViews(std::shared_ptr<const ViewPrograms> programs)
    : m_programs(std::move(programs)),
      m_viewer(part_of(m_programs, &ViewPrograms::viewer)),
      m_meter(part_of(m_programs, &ViewPrograms::meter)),
      m_cells(part_of(m_programs, &ViewPrograms::cells)) {}

void FirstViews::expect(const Look& look, const Plan& plan) {
    for (std::size_t i = 0; i < plan.targets.size(); ++i) {
        const PlannedTarget& target = plan.targets[i];
        const bool has_levels = std::max(target.extent.width, target.extent.height) > 1;
        expect({target.format,
                encoding_of(look, static_cast<int>(i)),
                target.mipmapped && has_levels,
                {is_power_of_two(target.extent.width), is_power_of_two(target.extent.height)},
                look.passes[i].has_alpha});
    }
}

void FirstViews::expect(const Kind& kind) {
    if (!m_scheduled.insert(kind).second)
        return;
    for (const Way way : {Way::minified, Way::magnified, Way::numbers, Way::flashes})
        m_pending.push_back({kind, way});
    for (const Way way : {Way::minified_over_checker, Way::magnified_over_checker})
        if (kind.has_alpha)
            m_pending.push_back({kind, way});
}

// Without memory, later views report the error.
const gpu::Texture* FirstViews::picture_of(const Kind& kind) {
    if (m_displayed && m_displayed->kind == kind)
        return &m_displayed->canvas.texture();
    m_displayed.reset();
    auto made = gpu::Canvas::make(
        {small_side(kind.has_power_of_two[0]), small_side(kind.has_power_of_two[1])}, kind.format,
        kind.is_mipmapped);
    if (!made)
        return nullptr;
    return &m_displayed.emplace(Seen{kind, std::move(*made)}).canvas.texture();
}

void FirstViews::draw_next() {
    const PendingDraw pending = m_pending.front();
    m_pending.pop_front();
    if (const gpu::Texture* picture = picture_of(pending.kind))
        draw_views_of(*picture, pending);
    if (m_pending.empty())
        m_displayed.reset();
    gpu::finish();
}

void FirstViews::draw_views_of(const gpu::Texture& texture, const PendingDraw& pending) {
    if (pending.way == Way::flashes) {
        m_cells.draw(texture, pending.kind.encoding);
    } else if (pending.way == Way::numbers) {
        m_meter.start(texture, Channels::color);
        m_meter.stop();
    } else {
        view(texture, pending);
    }
}

void FirstViews::view(const gpu::Texture& texture, const PendingDraw& pending) {
    const auto view = gpu::Canvas::make(view_extent, Format::rgba8);
    if (!view)
        return;
    ViewOptions options{.encoding = pending.kind.encoding};
    if (pending.way == Way::magnified || pending.way == Way::magnified_over_checker)
        options.width = options.height = 4.0;
    options.is_over_checker =
        pending.way == Way::minified_over_checker || pending.way == Way::magnified_over_checker;
    m_viewer.draw(texture, *view, options);
}
