#include "ui/library/library_column.h"

#include "ui/library/library_panel.h"
#include "ui/library/preset_list.h"
#include "ui/library/stack_panel.h"
#include "ui/playback/signal_panel.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <cmath>

void draw_library_column(const Scene& scene, Edits& edits) {
    constexpr float looks_share = 0.26f;
    constexpr float presets_share = 0.3f;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float gap = 4.0f * scene.scale;
    const Rect looks{0.0f, 0.0f, room.x, std::floor(room.y * looks_share)};
    const Rect presets{0.0f, looks.bottom() + gap, room.x, std::floor(room.y * presets_share)};
    const float top = presets.bottom() + gap;
    {
        const Pane pane("library", looks, theme::pane, true, false);
        draw_library_panel(scene, edits);
    }
    {
        const Pane pane("presets", presets, theme::pane, true, false);
        draw_preset_list(scene, edits);
    }
    const Pane pane("signal", {0.0f, top, room.x, room.y - top}, theme::pane);
    draw_stack_panel(scene, edits);
    draw_signal_panel(scene, edits);
}
