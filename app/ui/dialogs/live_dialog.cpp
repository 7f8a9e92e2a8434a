#include "ui/dialogs/live_dialog.h"

#include "lab/commands/content_commands.h"
#include "lab/media/live_choices.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/dialog_rows.h"
#include "ui/widgets/widgets.h"

#include <algorithm>

namespace {
// A click chooses, a double click shows it. True after a double click.
bool draw_list(std::string& typed, const LiveChoices& choices, Edits& edits) {
    constexpr float rows = 10.0f;
    bool is_done = false;
    const ImVec2 size(0.0f, rows * ImGui::GetTextLineHeightWithSpacing());
    if (ImGui::BeginChild("##live", size, true)) {
        for (const LiveChoice& choice : choices.all()) {
            if (ImGui::Selectable(choice.label.c_str(), choice.picture == typed,
                                  ImGuiSelectableFlags_AllowDoubleClick)) {
                typed = choice.picture;
                is_done = is_done || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
            }
            edits.mark("live:" + choice.picture);
        }
        if (!choices.problem().empty())
            wrapped_dim_text(choices.problem());
    }
    ImGui::EndChild();
    return is_done;
}
}  // namespace

void draw_live_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("Live source", 40.0f, scene, edits);
    if (!frame.is_open())
        return;
    edits.change([](LiveChoices& choices) { choices.refresh(); });
    std::string typed = scene.window.dialog.text;
    const bool is_done = draw_list(typed, scene.lab.live, edits);
    dialog_row("Source");
    typed = dialog_text("live_source_text", typed, "screen:area=0x0+640+480",
                        ImGui::GetContentRegionAvail().x, edits);
    dialog_row("");
    wrapped_dim_text("Add settings after commas: fit=whole, rate=30, cursor=on.");
    draw_dialog_problem(scene.window.dialog.problem, edits);
    edits.arrange([typed](WindowState& window) { window.dialog.text = typed; });
    if (draw_dialog_buttons("Show", !typed.empty(), edits) || is_done)
        finish_dialog(edits, [typed](ContentCommands& content) { content.show_live(typed); });
}
