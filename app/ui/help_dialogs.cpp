#include "ui/help_dialogs.h"

#include "ui/actions.h"
#include "ui/dialog_frame.h"
#include "ui/scoped.h"
#include "ui/theme.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>

namespace {
constexpr std::array<std::pair<const char*, const char*>, 7> mouse_habits{
    {{"Drag on a slider", "turn it; with Shift ten times finer, with Alt ten times coarser"},
     {"Ctrl+click or double click", "type a value, also beyond the slider's ends"},
     {"Click on a name", "what it is, where it is declared, where its slider ends"},
     {"Wheel over a picture", "zoom about the pointer"},
     {"Drag a picture", "move it; in a look that can be turned (Caffeine) turn the object"},
     {"Right button, Ctrl + wheel", "there: move the camera around, nearer or farther"},
     {"Escape", "stop what takes long, go back to the picture, close a dialog"}}};

void line(const std::string& keys, const std::string& words, const Scene& scene) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    {
        const ScopedFont font(scene.fonts.numbers);
        const ScopedColor color(ImGuiCol_Text, theme::accent);
        ImGui::TextUnformatted(keys.c_str());
    }
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", words.c_str());
}

template <class Lines>
void draw_table(const char* id, const Lines& lines) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit))
        return;
    ImGui::TableSetupColumn("keys");
    ImGui::TableSetupColumn("words", ImGuiTableColumnFlags_WidthStretch);
    lines();
    ImGui::EndTable();
}

// As high as what it holds, and no higher than the window has room for; then it scrolls.
void draw_in_room(const char* id, const std::function<void()>& draw) {
    const float around = 5.0f * ImGui::GetFrameHeightWithSpacing();  // title, close, paddings
    const float most = ImGui::GetIO().DisplaySize.y - around;
    float& wanted = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID(id), most);
    {  // of this part alone: what pops up above it has its own
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::BeginChild(id, {0.0f, std::min(wanted, most)});
    }
    draw();
    wanted = ImGui::GetCursorPosY();
    ImGui::EndChild();
}

void draw_keys(const Scene& scene) {
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_CellPadding,
                                      ImVec2(4.0f * scene.scale, 0.5f * scene.scale));
    std::vector<const Action*> with_keys;
    for (const Action& action : all_actions())
        if (action.chord.key != 0)
            with_keys.push_back(&action);
    constexpr std::size_t columns = 3;
    const std::size_t length = (with_keys.size() + columns - 1) / columns;
    if (ImGui::BeginTable("##columns", static_cast<int>(columns))) {
        for (std::size_t first = 0; first < with_keys.size(); first += length) {
            ImGui::TableNextColumn();
            draw_table(std::to_string(first).c_str(), [&] {
                for (std::size_t i = first; i < std::min(first + length, with_keys.size()); ++i)
                    line(chord_text(with_keys[i]->chord), with_keys[i]->label, scene);
            });
        }
        ImGui::EndTable();
    }
    ImGui::Separator();
    draw_table("##mouse", [&] {
        for (const auto& [keys, words] : mouse_habits)
            line(keys, words, scene);
    });
}
}  // namespace

void draw_keys_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("Keys", 72.0f, scene, edits);
    if (!frame.is_open())
        return;
    draw_in_room("##keys", [&] { draw_keys(scene); });
    draw_close_button("Close", edits);
}

void draw_about_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("About Afterglow", 32.0f, scene, edits);
    if (!frame.is_open())
        return;
    ImGui::TextWrapped(
        "A lab for the CRT, phosphor and oscilloscope look: open a look, turn its "
        "parameters, edit its shaders, and share what you found as a preset.");
    ImGui::Spacing();
    dim_text("Looks and presets");
    ImGui::TextWrapped("%s", scene.lab.library().roots().program.string().c_str());
    dim_text("Your own");
    ImGui::TextWrapped("%s", scene.lab.library().roots().user.string().c_str());
    draw_close_button("Close", edits);
}
