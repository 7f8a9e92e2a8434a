#include "ui/dialogs/new_look_dialog.h"

#include "lab/commands/look_commands.h"
#include "lab/library/look_templates.h"
#include "lab/storage/display_name.h"
#include "lab/storage/name_check.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/name_field.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>

namespace {
// A picture with the template's name below it. Returns whether it is clicked.
bool draw_card(const LookTemplate& look, bool is_chosen, float width, const Scene& scene) {
    const float height = std::round(width * 9.0f / 16.0f);
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const bool is_clicked = ImGui::InvisibleButton("##card", {width, height + line});
    const bool is_hovered = ImGui::IsItemHovered();
    const ImVec2 high(low.x + width, low.y + height);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, theme::packed(theme::surround));
    if (const ViewImage image = scene.pictures.looks.of(look.folder); image.handle != 0)
        list.AddImage(texture_id(image.handle), low, high, {0.0f, 1.0f}, {1.0f, 0.0f});
    const theme::Color frame = is_chosen ? theme::accent : is_hovered ? theme::label : theme::line;
    list.AddRect(low, high, theme::packed(frame), 0.0f, 0, (is_chosen ? 2.0f : 1.0f) * scene.scale);
    list.AddText({low.x, high.y + 3.0f * scene.scale},
                 theme::packed(is_chosen ? theme::accent : theme::text), look.name.c_str());
    return is_clicked;
}

std::size_t draw_templates(const std::vector<LookTemplate>& templates, const Scene& scene,
                           Edits& edits) {
    const auto count = static_cast<float>(templates.size());
    const float gap = ImGui::GetFontSize() * 0.7f;
    const float room = ImGui::GetContentRegionAvail().x;
    const float width = std::floor((room - gap * (count - 1.0f)) / count);
    auto chosen = std::min(static_cast<std::size_t>(std::max(scene.window.dialog.chosen, 0)),
                           templates.size() - 1);
    for (std::size_t i = 0; i < templates.size(); ++i) {
        const ScopedId id(templates[i].id);
        if (i > 0)
            ImGui::SameLine(0.0f, gap);
        if (draw_card(templates[i], i == chosen, width, scene)) {
            edits.arrange([i](WindowState& window) { window.dialog.chosen = static_cast<int>(i); });
            chosen = i;
        }
        edits.mark("template:" + templates[i].id);
    }
    return chosen;
}
}  // namespace

void draw_new_look_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("New look", 40.0f, scene, edits);
    if (!frame.is_open())
        return;
    const std::vector<LookTemplate>& templates = scene.library_view.templates();
    if (templates.empty()) {
        wrapped_dim_text("The program's templates are missing. Reinstall Afterglow.");
        draw_close_button("Close", edits);
        return;
    }
    const LookTemplate& chosen = templates[draw_templates(templates, scene, edits)];
    wrapped_dim_text(chosen.about);
    ImGui::Spacing();
    dim_text("Folder name");
    const std::string id = draw_name_field(scene, edits);
    const NameCheck check = check_look_id(id);
    if (const auto suggestion = draw_name_advice(check, edits))
        replace_name(*suggestion, edits);
    const std::string taken = check.is_valid ? scene.lab.looks.problem_of_id(id) : std::string();
    const std::string& problem = taken.empty() ? scene.window.dialog.problem : taken;
    if (check.is_valid && !problem.empty())
        draw_dialog_problem(problem, edits);
    else if (check.is_valid)
        dim_text("Created in " + display_folder(scene.roots.user / "shaders"));
    if (!draw_dialog_buttons("Create", check.is_valid && taken.empty(), edits))
        return;
    finish_dialog(edits, [id, from = chosen.id](LookCommands& looks) { looks.create(id, from); });
}
