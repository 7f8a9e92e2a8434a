#include "ui/window/window_panes.h"

#include "ui/actions/remote_actions.h"
#include "ui/actions/shortcuts.h"
#include "ui/dialogs/dialogs.h"
#include "ui/panels/bottom_pane.h"
#include "ui/panels/panel_table.h"
#include "ui/parameters/sheet_panel.h"
#include "ui/parameters/step_view.h"
#include "ui/picture/picture_panel.h"
#include "ui/playback/transport_bar.h"
#include "ui/status/status_bar.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/window/focus_keys.h"
#include "ui/window/layout.h"
#include "ui/window/menu_bar.h"

namespace {
// Transparent panes keep the clear colour. On software GL, filling them again costs as much as
// drawing the panels.
theme::Color background_of(PanelFrame frame) {
    return frame == PanelFrame::own ? theme::none : theme::pane;
}

void draw_panel(PanelPlace place, const Scene& scene, const Layout& layout, Edits& edits) {
    const auto found = layout.panels.find(place);
    const auto id = scene.window.layout.panels.shown_in(place);
    if (!id || found == layout.panels.end() || !found->second.is_shown())
        return;
    if (place == PanelPlace::bottom) {
        const Pane pane("bottom", found->second, theme::pane);
        begin_pane_focus(scene);
        return draw_bottom_pane(scene, edits);
    }
    const Panel& panel = panel_of(*id);
    const Pane pane(panel.title, found->second, background_of(panel.frame),
                    panel.frame != PanelFrame::own, panel.frame == PanelFrame::scrolling);
    begin_pane_focus(scene);
    panel.draw(scene, edits);
}

void draw_panes(const Scene& scene, const Layout& layout, Edits& edits) {
    draw_panel(PanelPlace::left, scene, layout, edits);
    if (layout.transport.is_shown()) {
        const Pane pane("transport", layout.transport, theme::pane, true, false);
        begin_pane_focus(scene);
        draw_transport_bar(scene, edits);
    }
    {
        const Pane pane("picture", layout.picture, theme::none, false);
        begin_pane_focus(scene);
        draw_picture_panel(scene, layout.picture, edits);
    }
    for (const PanelPlace place :
         {PanelPlace::strip, PanelPlace::bottom, PanelPlace::right, PanelPlace::lower_right})
        draw_panel(place, scene, layout, edits);
    if (layout.status.is_shown()) {
        const Pane pane("status", layout.status, theme::pane, true, false);
        begin_pane_focus(scene);
        draw_status_bar(scene, edits);
    }
}
}  // namespace

void draw_window(const Scene& scene, Edits& edits) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize(size);
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                             ImGuiWindowFlags_NoSavedSettings |
                             ImGuiWindowFlags_NoBringToFrontOnFocus |
                             ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBackground;
    if (!scene.window.layout.is_picture_only)
        flags |= ImGuiWindowFlags_MenuBar;
    follow_focus_keys(scene, edits);
    {
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::Begin(main_window_name, nullptr, flags);
    }
    if (!scene.window.layout.is_picture_only)
        draw_menu_bar(scene, edits);
    const float top = scene.window.layout.is_picture_only ? 0.0f : ImGui::GetFrameHeight();
    const Layout layout =
        arrange_panes(scene.window.layout, {0.0f, top, size.x, size.y - top}, scene.scale);
    draw_panes(scene, layout, edits);
    draw_splitters(layout, scene.scale, edits);
    ImGui::End();
    follow_pointer(scene, edits);
    leave_hidden_sheet(scene, edits);
    draw_dialogs(scene, edits);
    draw_focus_frame(scene, edits);
    run_shortcuts(scene, edits);
    run_requested_action(scene, edits);
}
