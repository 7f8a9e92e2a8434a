#include "ui/library/unsaved_menu.h"

#include "lab/commands/look_commands.h"
#include "lab/views/stash_thumbnails.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace {
// The name in the list of looks: "Phosphor + CRT".
std::string look_name(const std::string& id, const Scene& scene) {
    const auto& looks = scene.library_view.looks();
    const auto found =
        std::ranges::find_if(looks, [&](const ListedLook& look) { return look.entry.id == id; });
    return found == looks.end() ? id : found->name;
}

double age_of(const StashedSession& kept) {
    const auto now = std::filesystem::file_time_type::clock::now();
    return std::max(std::chrono::duration<double>(now - kept.time).count(), 0.0);
}

std::string changes_text(const StashedSession& kept) {
    const std::string age = age_text(age_of(kept));
    return kept.changes == 1 ? fmt::format("1 change · {}", age)
                             : fmt::format("{} changes · {}", kept.changes, age);
}

void draw_entry(const StashedSession& kept, const Scene& scene, Edits& edits) {
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const ImVec2 size(ImGui::GetFontSize() * 22.0f, line * 2.0f + 4.0f);
    const float picture_width = size.y * 16.0f / 9.0f;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##kept", false, 0, size))
        edits.open_unsaved(kept.file);
    edits.mark("kept:" + kept.file.stem().string());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end(low.x + picture_width, low.y + size.y);
    list.AddRectFilled(low, end, theme::packed(theme::surround));
    if (const ViewImage image = scene.pictures.kept.of(kept.picture); image.handle != 0) {
        const float factor = std::min(picture_width / static_cast<float>(image.extent.width),
                                      size.y / static_cast<float>(image.extent.height));
        const ImVec2 half(static_cast<float>(image.extent.width) * factor * 0.5f,
                          static_cast<float>(image.extent.height) * factor * 0.5f);
        const ImVec2 middle((low.x + end.x) * 0.5f, (low.y + end.y) * 0.5f);
        list.AddImage(texture_id(image.handle), {middle.x - half.x, middle.y - half.y},
                      {middle.x + half.x, middle.y + half.y}, {0.0f, 1.0f}, {1.0f, 0.0f});
    }
    const float left = end.x + ImGui::GetFontSize() * 0.6f;
    const std::string title = fmt::format("{} – {}", look_name(kept.look, scene),
                                          kept.preset.empty() ? "Default" : kept.preset);
    list.AddText({left, low.y + 1.0f}, theme::packed(theme::text),
                 elided_to_width(title, low.x + size.x - left).c_str());
    list.AddText({left, low.y + line + 1.0f}, theme::packed(theme::dim),
                 changes_text(kept).c_str());
}
}  // namespace

void draw_unsaved_menu(const Scene& scene, Edits& edits) {
    const auto& kept = scene.lab.looks.stash().list();
    if (kept.empty())
        return;
    const bool is_open = ImGui::BeginMenu("Unsaved changes");
    edits.mark("menu:Unsaved changes");
    if (!is_open)
        return;
    for (const StashedSession& session : kept) {
        const ScopedId id(session.file.string());
        draw_entry(session, scene, edits);
    }
    ImGui::EndMenu();
}
