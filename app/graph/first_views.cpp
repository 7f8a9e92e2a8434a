#include "graph/first_views.h"

#include "gpu/canvas.h"
#include "gpu/draw.h"

#include <algorithm>
#include <bit>

namespace {
constexpr Extent view_extent{24, 24};  // smaller than what is looked at

bool is_power_of_two(int length) {
    return std::has_single_bit(static_cast<unsigned>(std::max(length, 1)));
}

int small_side(bool has_power_of_two) {
    return has_power_of_two ? 64 : 96;
}
}  // namespace

FirstViews::FirstViews(Viewer viewer, Meter meter, LightCells cells)
    : m_viewer(std::move(viewer)), m_meter(std::move(meter)), m_cells(std::move(cells)) {}

Result<FirstViews> FirstViews::make() {
    auto viewer = Viewer::make();
    if (!viewer)
        return fail(viewer.error());
    auto meter = Meter::make();
    if (!meter)
        return fail(meter.error());
    auto cells = LightCells::make();
    if (!cells)
        return fail(cells.error());
    return FirstViews(std::move(*viewer), std::move(*meter), std::move(*cells));
}

std::size_t FirstViews::look_at(const Look& look, const Plan& plan) {
    const std::size_t before = m_met.size();
    for (std::size_t i = 0; i < plan.targets.size(); ++i) {
        const PlannedTarget& target = plan.targets[i];
        const Kind kind{
            target.format,
            encoding_of(look, static_cast<int>(i)),
            target.mipmapped,
            {is_power_of_two(target.extent.width), is_power_of_two(target.extent.height)},
            look.passes[i].has_alpha};
        if (m_met.insert(kind).second)
            look_at(kind);
    }
    return m_met.size() - before;
}

// Where there is no memory, those who look later will say so.
void FirstViews::look_at(const Kind& kind) {
    const Extent extent{small_side(kind.has_power_of_two[0]), small_side(kind.has_power_of_two[1])};
    const auto seen = gpu::Canvas::make(extent, kind.format, kind.is_mipmapped);
    const auto view = gpu::Canvas::make(view_extent, Format::rgba8);
    if (!seen || !view)
        return;
    const gpu::Texture& texture = seen->texture();
    ViewOptions options{.encoding = kind.encoding};
    m_viewer.draw(texture, *view, options);
    options.width = options.height = 4.0;  // now texels are magnified
    m_viewer.draw(texture, *view, options);
    if (kind.has_alpha) {
        options.is_over_checker = true;
        m_viewer.draw(texture, *view, options);
        options.width = options.height = 0.0;
        m_viewer.draw(texture, *view, options);
    }
    m_meter.start(texture, ChannelChoice::rgb);
    m_meter.stop();
    m_cells.draw(texture, kind.encoding);
    gpu::finish();
}
