#include "lab/menus/window_menu.h"

#include "lab/media/render_size.h"
#include "lab/messages/messages.h"
#include "lab/window/window_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
MenuEntry sized(std::string name, const PictureSize& size, bool is_present) {
    return {.name = std::move(name),
            .commands = {[size](RenderSize& render_size) { render_size.choose(size); }},
            .is_present = is_present};
}

MenuSection size_section(const EffectiveSize& in_force) {
    MenuSection section{"Render size"};
    const PictureSize& current = in_force.chosen;
    PictureSize size = current;
    for (const auto& [shape, name] : picture_shapes)
        section.entries.push_back(
            sized(name, with_shape(current, shape), in_force.is_shaped(shape)));
    section.entries.push_back({.name = "Match pane once", .commands = {[](RenderSize& render_size) {
                                                              render_size.fix_to_view();
                                                          }}});
    for (const Extent& extent : picture_sizes)
        section.entries.push_back(sized(fmt::format("{} × {}", extent.width, extent.height),
                                        {false, extent, current.scale, current.shape},
                                        current.is_exactly(extent)));
    for (const double scale : picture_scales) {
        size = current;
        size.scale = scale;
        section.entries.push_back(
            sized(fmt::format("Scale {}", times_text(scale)), size, current.scale == scale));
    }
    return section;
}

MenuSection zoom_section(const PictureView& current) {
    MenuSection section{"Zoom"};
    section.entries.push_back({.name = "Largest integer zoom",
                               .commands = {[](WindowState& window) {
                                   window.views.large() = {PictureView::Fit::integer};
                               }},
                               .is_present = current.fit == PictureView::Fit::integer});
    for (const double zoom : picture_zooms)
        section.entries.push_back(
            {.name = times_text(zoom),
             .commands = {[zoom](WindowState& window) {
                 window.views.large().fit = PictureView::Fit::free;
                 window.views.large().zoom = zoom;
             }},
             .is_present = current.fit == PictureView::Fit::free && current.zoom == zoom});
    for (const auto& [name, x, y] :
         {std::tuple{"Pan left", -0.1, 0.0}, std::tuple{"Pan right", 0.1, 0.0},
          std::tuple{"Pan up", 0.0, -0.1}, std::tuple{"Pan down", 0.0, 0.1}})
        section.entries.push_back({.name = name, .commands = {[x = x, y = y](WindowState& window) {
                                                     PictureView& view = window.views.large();
                                                     view.x = std::clamp(view.x + x, 0.0, 1.0);
                                                     view.y = std::clamp(view.y + y, 0.0, 1.0);
                                                 }}});
    return section;
}

MenuSection pane_section() {
    MenuSection section{"Pane"};
    constexpr float step = 40.0f;
    for (const PaneSide& side : pane_sides())
        for (const float by : {step, -step})
            section.entries.push_back({.name = by > 0.0f ? side.larger : side.smaller,
                                       .commands = {[size = side.size, by](WindowState& window) {
                                           resize_pane(window.layout.sizes, size, by);
                                       }}});
    return section;
}

MenuSection pin_section(const std::vector<Pin>& pins) {
    MenuSection section{"Pins"};
    section.entries.push_back({.name = "Pin picture centre",
                               .commands = {[](WindowState& window) { add_pin(window, {}); }}});
    for (std::size_t i = 0; i < pins.size(); ++i)
        section.entries.push_back({.name = fmt::format("Remove pin {}", i + 1),
                                   .commands = {[i](WindowState& window) {
                                       if (i < window.probes.pins.size())
                                           window.probes.pins.erase(window.probes.pins.begin() +
                                                                    static_cast<std::ptrdiff_t>(i));
                                   }}});
    return section;
}

void show_waveform(WindowState& window) {
    window.layout.reveal(panel_id::waveform);
}

MenuSection waveform_section(const WindowState& window, Extent picture) {
    MenuSection section{"Waveform"};
    for (const bool is_luminance : {false, true})
        section.entries.push_back({.name = is_luminance ? "Luminance" : "Red, green and blue",
                                   .commands = {[is_luminance](WindowState& changed) {
                                       changed.probes.plots_luminance = is_luminance;
                                       show_waveform(changed);
                                   }},
                                   .is_present = window.probes.plots_luminance == is_luminance});
    const double row = window.probes.scan_line.row(picture).value_or(
        window.probes.scan_line.start.texel(picture)[1]);
    section.entries.push_back(
        {.name = "Row…",
         .number = NumberPrompt{
             .current = row,
             .limit = {0.0, std::max(picture.height - 1.0, 0.0)},
             .is_whole = true,
             .answer = [height = picture.height](double typed) -> std::vector<Edit> {
                 return {[row = static_cast<int>(typed), height](WindowState& changed) {
                     changed.probes.scan_line = ScanLine::along_row(row, height);
                     show_waveform(changed);
                 }};
             }}});
    return section;
}

MenuEntry window_number(const char* name, const char* unit, double current, Limit limit,
                        void (*set)(WindowState& window, double number)) {
    return {.name = name,
            .number = NumberPrompt{.current = current,
                                   .unit = unit,
                                   .limit = limit,
                                   .answer = [set](double number) -> std::vector<Edit> {
                                       return {[set, number](WindowState& window) {
                                           set(window, number);
                                       }};
                                   }}};
}

MenuSection number_section(const WindowState& window) {
    MenuSection section{"Set"};
    section.entries = {
        window_number("Frame budget…", "ms", window.frame_rate.budget_milliseconds, {0.1, 1000.0},
                      [](WindowState& changed, double number) {
                          changed.frame_rate.budget_milliseconds = number;
                      }),
        window_number("Flash limiter…", "× full brightness per second",
                      window.flashes.limit.max_per_second,
                      {FlashLimit::lowest, FlashLimit::highest},
                      [](WindowState& changed, double number) {
                          changed.flashes.limit = {.is_on = true, .max_per_second = number};
                      }),
        window_number("Wipe position…", "%", 100.0 * window.views.wipe_share, {0.0, 100.0},
                      [](WindowState& changed, double number) {
                          changed.views.wipe_share = number / 100.0;
                      })};
    return section;
}
}  // namespace

void add_pin(WindowState& window, const Pin& pin) {
    constexpr std::size_t maximum = 4;  // fit into the table
    if (window.probes.pins.size() == maximum)
        window.probes.pins.erase(window.probes.pins.begin());
    window.probes.pins.push_back(pin);
    window.layout.panels.show(panel_id::pins);
}

std::string times_text(double factor) {
    if (factor < 1.0 && 1.0 / factor == std::floor(1.0 / factor))
        return fmt::format("1/{:g}×", 1.0 / factor);
    return fmt::format("{:g}×", factor);
}

EffectiveSize effective_size(const RenderSize& render_size) {
    return {render_size.chosen(), render_size.shape(), render_size.extent()};
}

void offer_display_size(const RenderSize& render_size, Messages& messages, Extent display) {
    const PictureSize& current = render_size.chosen();
    if (current.follows_view || current.room(display) == display)
        return;
    const Extent picture = render_size.extent();
    messages.offer(
        fmt::format("The render size is {} × {} px, the display {} × {} px", picture.width,
                    picture.height, display.width, display.height),
        {.name = "Match display", .commands = {[](RenderSize& fixed) { fixed.fix_to_view(); }}});
}

PictureSize with_shape(PictureSize size, ViewShape shape) {
    size.follows_view = true;
    size.shape = shape;
    return size;
}

std::vector<MenuSection> window_sections(const WindowState& window, const EffectiveSize& size) {
    return {size_section(size),
            zoom_section(window.views.large()),
            pane_section(),
            pin_section(window.probes.pins),
            waveform_section(window, size.extent),
            number_section(window)};
}
