#include "ui/panels/bottom_pane.h"

#include "ui/panels/panel_table.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <string>
#include <vector>

namespace {
using Tabs = std::vector<const Panel*>;

float tab_width(const Panel& panel) {
    constexpr float gap = 2.0f;
    return ImGui::CalcTextSize(panel.tab).x + 2.0f * ImGui::GetStyle().FramePadding.x + gap;
}

// The tabs that fit into `room`; the one that is shown is among them.
Tabs fitting(const Tabs& tabs, const Panel& shown, float room) {
    float width = tab_width(shown);
    Tabs fitting;
    for (const Panel* tab : tabs) {
        if (tab != &shown)
            width += tab_width(*tab);
        if (tab == &shown || width <= room)
            fitting.push_back(tab);
    }
    return fitting;
}

void show(const Panel& panel, Edits& edits) {
    edits.arrange([id = panel.id](WindowState& window) { window.layout.panels.show(id); });
}

// A list of the tabs that do not fit.
void draw_more(const Tabs& tabs, const Tabs& visible, Edits& edits) {
    if (icon_button("##more", Icon::down, "More panels", theme::dim))
        ImGui::OpenPopup("##more_panels");
    edits.mark("bottom_more");
    if (!ImGui::BeginPopup("##more_panels"))
        return;
    for (const Panel* tab : tabs) {
        if (std::ranges::find(visible, tab) != visible.end())
            continue;
        if (ImGui::MenuItem(tab->tab))
            show(*tab, edits);
        edits.mark(std::string("bottom_more:") + tab->tab);
    }
    ImGui::EndPopup();
}

void draw_tabs(const Tabs& tabs, const Panel& shown, Edits& edits) {
    const float button = ImGui::GetFrameHeight();
    const float room = ImGui::GetContentRegionAvail().x - button;
    Tabs visible = fitting(tabs, shown, room);
    const bool has_more = visible.size() < tabs.size();
    if (has_more)
        visible = fitting(tabs, shown, room - button);
    std::vector<const char*> labels;
    for (const Panel* tab : visible)
        labels.push_back(tab->tab);
    const auto current = static_cast<int>(std::ranges::find(visible, &shown) - visible.begin());
    const int chosen =
        choice("bottom", labels.data(), static_cast<int>(labels.size()), current, edits);
    if (chosen != current)
        show(*visible[static_cast<std::size_t>(chosen)], edits);
    if (!has_more)
        return;
    ImGui::SameLine(0.0f, 0.0f);
    draw_more(tabs, visible, edits);
}
}  // namespace

void draw_bottom_pane(const Scene& scene, Edits& edits) {
    Tabs tabs;
    for (const Panel& panel : panels())
        if (panel.place == PanelPlace::bottom)
            tabs.push_back(&panel);
    const auto open = std::ranges::find_if(
        tabs, [&](const Panel* panel) { return scene.window.layout.panels.shows(panel->id); });
    const Panel& shown = open == tabs.end() ? *tabs.front() : **open;
    draw_tabs(tabs, shown, edits);
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
