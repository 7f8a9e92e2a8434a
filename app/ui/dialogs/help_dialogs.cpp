#include "ui/dialogs/help_dialogs.h"

#include "ui/dialogs/dialog_frame.h"
#include "ui/frame/action.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>

namespace {
constexpr std::array<std::pair<const char*, const char*>, 8> mouse_habits{
    {{"Drag a slider", "Change the value (Shift: 10× finer, Alt: 10× coarser)"},
     {"Ctrl+click or double-click", "Type a value, even beyond the slider's range"},
     {"Click a parameter name", "Show its help, its declaration and its slider range"},
     {"Scroll over a picture", "Zoom at the pointer"},
     {"Drag a picture", "Pan, or rotate the object in 3D looks (Caffeine)"},
     {"Right-drag, Ctrl+scroll", "Orbit the camera, move it nearer or farther (3D looks)"},
     {"F10", "Open the menus (arrow keys, Enter, Esc)"},
     {"Esc", "Stop a long task, return to the picture or close a dialog"}}};

void line(const std::string& keys, const std::string& text) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    {
        const ScopedColor color(ImGuiCol_Text, theme::accent);
        ImGui::TextUnformatted(keys.c_str());
    }
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", text.c_str());
}

/// The keys of one menu.
struct KeyGroup {
    const char* title;
    std::vector<const Action*> actions;

    std::size_t lines() const { return actions.size() + 2; }  // includes the title and a gap
};

std::vector<KeyGroup> key_groups(const Scene& scene) {
    std::vector<KeyGroup> groups;
    for (const auto& [menu, title] :
         {std::pair{Menu::file, "File"}, std::pair{Menu::edit, "Edit"},
          std::pair{Menu::parameter, "Parameter"}, std::pair{Menu::playback, "Playback"},
          std::pair{Menu::view, "View"}, std::pair{Menu::output, "Output"},
          std::pair{Menu::frame_rate, "Frame rate"}, std::pair{Menu::compare, "Compare"},
          std::pair{Menu::pass, "Pass"}, std::pair{Menu::help, "Help"}}) {
        KeyGroup group{title, {}};
        for (const Action& action : scene.actions.rows())
            if (action.menu == menu && action.chord.key != 0)
                group.actions.push_back(&action);
        if (!group.actions.empty())
            groups.push_back(std::move(group));
    }
    return groups;
}

// Distributes whole groups over at most `count` columns. Keeps their order and minimises the
// longest column.
std::vector<std::vector<KeyGroup>> in_columns(std::vector<KeyGroup> groups, std::size_t count) {
    const auto filled = [&](std::size_t maximum) {
        std::vector<std::vector<KeyGroup>> columns(1);
        std::size_t lines = 0;
        for (const KeyGroup& group : groups) {
            if (lines > 0 && lines + group.lines() > maximum) {
                columns.emplace_back();
                lines = 0;
            }
            lines += group.lines();
            columns.back().push_back(group);
        }
        return columns;
    };
    std::size_t maximum = 1;
    while (filled(maximum).size() > count)
        ++maximum;
    return filled(maximum);
}

template <class Lines>
void draw_table(const char* id, float keys_width, const Lines& lines) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit))
        return;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, keys_width);
    ImGui::TableSetupColumn("words", ImGuiTableColumnFlags_WidthStretch);
    lines();
    ImGui::EndTable();
}

// Sizes the area to its content, limited by the window height. Longer content scrolls.
void draw_in_room(const char* id, const std::function<void()>& draw) {
    const float around = 5.0f * ImGui::GetFrameHeightWithSpacing();  // title, close button, padding
    const float maximum = ImGui::GetIO().DisplaySize.y - around;
    float& wanted = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID(id), maximum);
    {  // only for this child: popups above it keep their own padding
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::BeginChild(id, {0.0f, std::min(wanted, maximum)});
    }
    draw();
    wanted = ImGui::GetCursorPosY();
    ImGui::EndChild();
}

float width_of_keys(const std::vector<KeyGroup>& column) {
    float widest = 0.0f;
    for (const KeyGroup& group : column)
        for (const Action* action : group.actions)
            widest = std::max(widest, ImGui::CalcTextSize(chord_text(action->chord).c_str()).x);
    return widest + ImGui::GetFontSize() * 0.5f;
}

void draw_group(const KeyGroup& group, float keys_width, const Scene& scene) {
    {
        const ScopedFont strong(scene.fonts.strong);
        ImGui::TextUnformatted(group.title);
    }
    draw_table(group.title, keys_width, [&] {
        for (const Action* action : group.actions)
            line(chord_text(action->chord), action->label);
    });
    ImGui::Spacing();
}

void draw_keys(const Scene& scene) {
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_CellPadding,
                                      ImVec2(4.0f * scene.scale, 0.5f * scene.scale));
    constexpr std::size_t columns = 3;
    if (ImGui::BeginTable("##columns", static_cast<int>(columns))) {
        for (const std::vector<KeyGroup>& column : in_columns(key_groups(scene), columns)) {
            ImGui::TableNextColumn();
            for (const KeyGroup& group : column)
                draw_group(group, width_of_keys(column), scene);
        }
        ImGui::EndTable();
    }
    ImGui::Separator();
    float mouse_width = 0.0f;
    for (const auto& [keys, text] : mouse_habits)
        mouse_width = std::max(mouse_width, ImGui::CalcTextSize(keys).x);
    draw_table("##mouse", mouse_width + ImGui::GetFontSize(), [&] {
        for (const auto& [keys, text] : mouse_habits)
            line(keys, text);
    });
}
}  // namespace

void draw_keys_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("Keyboard shortcuts", 72.0f, scene, edits);
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
        "A lab for CRT, phosphor and oscilloscope looks. Open a look, feed it sound or pictures, "
        "tune its parameters, edit its shaders and share the result as a preset.");
    ImGui::Spacing();
    dim_text("Shipped looks and presets");
    ImGui::TextWrapped("%s", scene.roots.program.string().c_str());
    dim_text("Your looks and presets");
    ImGui::TextWrapped("%s", scene.roots.user.string().c_str());
    draw_close_button("Close", edits);
}
