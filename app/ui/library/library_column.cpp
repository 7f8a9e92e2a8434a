#include "ui/library/library_column.h"

#include "ui/library/library_panel.h"
#include "ui/library/stack_panel.h"
#include "ui/playback/signal_panel.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>

void draw_library_column(const Scene& scene, Edits& edits) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    // The list has its full height, up to 55 %.
    std::size_t lines = 2;
    for (const ListedLook& look : scene.library_view.looks())
        lines += 1 + (scene.lab.document && look.entry.id == scene.lab.document->look().id
                          ? look.presets.size() + 1
                          : 0);
    const float wanted = static_cast<float>(lines) * ImGui::GetTextLineHeightWithSpacing() +
                         2.0f * ImGui::GetStyle().WindowPadding.y;
    const Rect upper{0.0f, 0.0f, room.x, std::min(wanted, room.y * 0.55f)};
    const float top = upper.height + 4.0f * scene.scale;
    {
        const Pane pane("library", upper, theme::pane);
        draw_library_panel(scene, edits);
    }
    const Pane pane("signal", {0.0f, top, room.x, room.y - top}, theme::pane);
    draw_stack_panel(scene, edits);
    draw_signal_panel(scene, edits);
}
