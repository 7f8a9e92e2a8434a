#include "ui/panels/bottom_pane.h"

#include "ui/panels/panel_table.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <vector>

void draw_bottom_pane(const Scene& scene, Edits& edits) {
    std::vector<const Panel*> tabs;
    std::vector<const char*> labels;
    int current = 0;
    for (const Panel& panel : panels()) {
        if (panel.place != PanelPlace::bottom)
            continue;
        if (scene.window.layout.panels.shows(panel.id))
            current = static_cast<int>(tabs.size());
        tabs.push_back(&panel);
        labels.push_back(panel.tab);
    }
    const int chosen =
        choice("bottom", labels.data(), static_cast<int>(labels.size()), current, edits);
    if (chosen != current)
        edits.arrange([id = tabs[static_cast<std::size_t>(chosen)]->id](WindowState& window) {
            window.layout.panels.show(id);
        });
    const Panel& shown = *tabs[static_cast<std::size_t>(current)];
    same_line_right(ImGui::GetFrameHeight());
    if (icon_button("##close", Icon::close, "Close", theme::dim))
        edits.arrange([id = shown.id](WindowState& window) { window.layout.panels.hide(id); });
    {  // only for this child: popups above it keep their own padding
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::BeginChild("##content", {0.0f, 0.0f}, false, ImGuiWindowFlags_NavFlattened);
    }
    shown.draw(scene, edits);
    ImGui::EndChild();
}
