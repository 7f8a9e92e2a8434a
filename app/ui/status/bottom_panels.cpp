#include "ui/status/bottom_panels.h"

#include "ui/library/presets_panel.h"
#include "ui/parameters/sheet_panel.h"
#include "ui/passes/pass_graph_panel.h"
#include "ui/passes/pass_inputs.h"
#include "ui/passes/pass_text.h"
#include "ui/passes/waveform_panel.h"
#include "ui/picture/pins_panel.h"
#include "ui/status/timings_panel.h"
#include "ui/widgets/problem_list.h"

#include <algorithm>
#include <array>

namespace {
constexpr float picture_height = 250.0f;

constexpr std::array panels{
    BottomPanel{BottomPart::problems,
                "Problems",
                ActionId::show_problems,
                "Problems",
                {'5', true},
                draw_problems_panel},
    BottomPanel{BottomPart::timings,
                "Timings",
                ActionId::show_timings,
                "Timings",
                {'6', true},
                draw_timings_panel},
    BottomPanel{BottomPart::pins,
                "Pins",
                ActionId::show_pins,
                "Pinned pixels",
                {'7', true},
                draw_pins_panel},
    BottomPanel{BottomPart::inputs,
                "Inputs",
                ActionId::show_inputs,
                "Inputs and uniforms",
                {'8', true},
                draw_pass_inputs},
    BottomPanel{BottomPart::text,
                "Compiled",
                ActionId::show_text,
                "Compiled source",
                {'9', true},
                draw_pass_text},
    BottomPanel{
        BottomPart::graph, "Graph", ActionId::show_graph, "Pass graph", {'G'}, draw_pass_graph},
    BottomPanel{BottomPart::sheet,
                "Filmstrip",
                ActionId::show_sheet,
                "Filmstrip and contact sheet",
                {'0', true},
                draw_sheet_panel},
    BottomPanel{BottomPart::waveform,
                "Waveform",
                ActionId::show_waveform,
                "Waveform along a line",
                {'L'},
                draw_waveform_panel},
    BottomPanel{BottomPart::presets,
                "Presets",
                ActionId::show_presets,
                "Preset browser",
                {'L', true},
                draw_presets_panel,
                picture_height,
                true},
};
}  // namespace

std::span<const BottomPanel> bottom_panels() {
    return panels;
}

bool is_chosen(const BottomPanel& panel, const WindowState& window) {
    return panel.least_height > 0.0f ? window.sees(panel.part)
                                     : window.shows_bottom && window.bottom_part == panel.part;
}

void toggle(const BottomPanel& panel, WindowState& window) {
    const bool shows = is_chosen(panel, window);
    window.shows_bottom = !shows;
    window.bottom_part = panel.part;
    if (panel.least_height <= 0.0f)
        return;
    window.is_picture_only = false;
    if (!shows)
        window.panes.bottom = std::max(window.panes.bottom, panel.least_height);
}
