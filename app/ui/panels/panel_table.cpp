#include "ui/panels/panel_table.h"

#include "ui/library/history_panel.h"
#include "ui/library/library_column.h"
#include "ui/library/presets_panel.h"
#include "ui/parameters/parameters_panel.h"
#include "ui/parameters/sheet_panel.h"
#include "ui/passes/inspector_panel.h"
#include "ui/passes/pass_graph_panel.h"
#include "ui/passes/pass_inputs.h"
#include "ui/passes/pass_strip.h"
#include "ui/passes/pass_text.h"
#include "ui/passes/waveform_panel.h"
#include "ui/picture/pins_panel.h"
#include "ui/playback/playlist_panel.h"
#include "ui/playback/timeline.h"
#include "ui/status/remote_panel.h"
#include "ui/status/timings_panel.h"
#include "ui/widgets/problem_list.h"

#include <algorithm>
#include <array>

namespace {
constexpr float picture_height = 250.0f;
constexpr float timeline_height = 190.0f;

// The session stores the position of a bottom panel, so new ones are added last.
constexpr std::array table{
    Panel{.id = panel_id::library,
          .title = "Looks and signal",
          .chord = {'1', true},
          .draw = draw_library_column,
          .place = PanelPlace::left,
          .is_open = true,
          .frame = PanelFrame::own},
    Panel{.id = panel_id::history,
          .title = "History",
          .chord = {'H', true},
          .draw = draw_history_panel,
          .place = PanelPlace::left,
          .covers = true,
          .menu = Menu::edit,
          .frame = PanelFrame::fixed,
          .leaves_full_screen = true},
    Panel{panel_id::parameters,
          "Parameters",
          {'2', true},
          draw_parameters_panel,
          "",
          PanelPlace::right,
          true},
    Panel{panel_id::inspector,
          "Inspector",
          {'3', true},
          draw_inspector_panel,
          "",
          PanelPlace::lower_right,
          true},
    Panel{panel_id::strip, "Pass strip", {'4', true}, draw_pass_strip, "", PanelPlace::strip, true},
    Panel{panel_id::problems, "Problems", {'5', true}, draw_problems_panel, "Problems"},
    Panel{panel_id::timings, "Timings", {'6', true}, draw_timings_panel, "Timings"},
    Panel{panel_id::pins, "Pinned pixels", {'7', true}, draw_pins_panel, "Pins"},
    Panel{"inputs", "Inputs and uniforms", {'8', true}, draw_pass_inputs, "Inputs"},
    Panel{"text", "Compiled source", {'9', true}, draw_pass_text, "Compiled"},
    Panel{"graph", "Pass graph", {'G'}, draw_pass_graph, "Graph"},
    Panel{
        panel_id::sheet, "Filmstrip and contact sheet", {'0', true}, draw_sheet_panel, "Filmstrip"},
    Panel{panel_id::waveform, "Waveform along a line", {'L'}, draw_waveform_panel, "Waveform"},
    Panel{.id = panel_id::presets,
          .title = "Preset browser",
          .chord = {'L', true},
          .draw = draw_presets_panel,
          .tab = "Presets",
          .min_height = picture_height,
          .leaves_full_screen = true,
          .needs_look = true},
    Panel{panel_id::remote, "Rejected remote messages", {}, draw_remote_panel, "Remote"},
    Panel{.id = panel_id::timeline,
          .title = "Timeline",
          .chord = {'T', false, true},
          .draw = draw_timeline_panel,
          .tab = "Timeline",
          .min_height = timeline_height},
    Panel{.id = panel_id::playlist,
          .title = "Playlist",
          .chord = {},
          .draw = draw_playlist_panel,
          .tab = "Playlist",
          .min_height = timeline_height},
};
}  // namespace

std::span<const Panel> panels() {
    return table;
}

std::vector<PanelKind> panel_kinds() {
    std::vector<PanelKind> kinds;
    for (const Panel& panel : table)
        kinds.push_back({panel.id, panel.place, panel.is_open, panel.covers});
    return kinds;
}

const Panel& panel_of(PanelId id) {
    return *std::ranges::find(table, id, &Panel::id);
}

bool is_chosen(const Panel& panel, const WindowState& window) {
    return panel.leaves_full_screen ? window.layout.sees(panel.id)
                                    : window.layout.panels.shows(panel.id);
}

void toggle(const Panel& panel, WindowState& window) {
    const bool is_shown = is_chosen(panel, window);
    if (panel.leaves_full_screen)
        window.layout.is_picture_only = false;
    if (is_shown)
        return window.layout.panels.hide(panel.id);
    window.layout.panels.show(panel.id);
    window.layout.sizes.bottom = std::max(window.layout.sizes.bottom, panel.min_height);
}
