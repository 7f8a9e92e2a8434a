#include "ui/dialogs/file_places.h"

#include "base/printable.h"
#include "lab/storage/display_name.h"
#include "lab/storage/roots.h"
#include "ui/dialogs/recent_files.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>

namespace fs = std::filesystem;

std::vector<Place> dialog_places(const Scene& scene) {
    std::vector<Place> places = desktop_places(home_folder());
    const auto add = [&places](const char* name, const fs::path& folder) {
        if (is_folder(folder))
            places.push_back({name, folder});
    };
    if (scene.lab.document)
        add("Open look", scene.lab.document->look().manifest.parent_path());
    add("My looks", scene.roots.user / "shaders");
    add("My presets", scene.roots.user / "presets");
    add("Shipped looks", scene.roots.program / "shaders");
    return places;
}

namespace {
std::optional<fs::path> draw_places(const std::vector<Place>& places, const fs::path& current,
                                    Edits& edits) {
    std::optional<fs::path> clicked;
    for (const Place& place : places) {
        const ScopedId id(place.folder.string());
        const float width = ImGui::GetContentRegionAvail().x;
        if (ImGui::Selectable(elided_to_width(printable(place.name), width).c_str(),
                              place.folder == current, ImGuiSelectableFlags_DontClosePopups))
            clicked = place.folder;
        edits.mark("place:" + place.name);
        tooltip(place.folder.string());
    }
    return clicked;
}

/// A part of a path and its folder.
struct PathPart {
    std::string label;
    fs::path folder;
};

// From the folder up to the root; the home folder and what is above it are one part.
std::vector<PathPart> parts_upwards(fs::path folder) {
    const fs::path home = home_folder();
    std::vector<PathPart> parts;
    while (folder != home && folder.has_relative_path()) {
        parts.push_back({printable(folder.filename().string()), folder});
        folder = folder.parent_path();
    }
    parts.push_back({folder == home && folder.has_relative_path() ? "Home" : "/", folder});
    return parts;
}

float button_width(const std::string& label) {
    return ImGui::CalcTextSize(label.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
}
}  // namespace

PlaceClick draw_file_places(const FileRules& rules, float height, const Scene& scene,
                            Edits& edits) {
    PlaceClick click;
    const Dialog& dialog = scene.window.dialog;
    const ScopedColor back(ImGuiCol_ChildBg, theme::surround);
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding,
                                      ImVec2(8.0f * scene.scale, 6.0f * scene.scale));
    const float width =
        std::min(12.0f * ImGui::GetFontSize(), 0.28f * ImGui::GetContentRegionAvail().x);
    ImGui::BeginChild("##places", {width, height}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    dim_text("Places");
    click.folder = draw_places(dialog.places, shown_path(dialog.browser).folder, edits);
    const auto files =
        rules.is_saving ? std::vector<fs::path>() : recent_files(scene, rules.extensions);
    if (!files.empty()) {
        ImGui::Spacing();
        dim_text("Recent");
        click.file = draw_recent_files(files, edits);
    }
    ImGui::EndChild();
    return click;
}

std::optional<fs::path> draw_folder_path(const fs::path& folder, float width, Edits& edits) {
    std::optional<fs::path> clicked;
    constexpr const char* cut = "…";
    const std::vector<PathPart> parts = parts_upwards(folder);
    const float gap = ImGui::GetFontSize() * 0.7f;
    float used = button_width(cut) + gap;
    std::size_t count = 0;
    while (count < parts.size() &&
           (count == 0 || used + button_width(parts[count].label) + gap <= width))
        used += button_width(parts[count++].label) + gap;
    ImGui::BeginGroup();
    if (count < parts.size()) {
        if (quiet_button(cut))
            clicked = parts[count].folder;
        tooltip(parts[count].folder.string());
    }
    for (std::size_t i = count; i-- > 0;) {
        const ScopedId id(static_cast<int>(i));
        if (i + 1 < parts.size()) {
            ImGui::SameLine(0.0f, gap * 0.25f);
            const bool follows_root = i + 1 < count && parts[i + 1].label == "/";
            if (!follows_root) {
                dim_text("/");
                ImGui::SameLine(0.0f, gap * 0.25f);
            }
        }
        const std::string label = elided_to_width(parts[i].label, width * 0.6f);
        if (quiet_button(label))
            clicked = parts[i].folder;
        edits.mark("folder:" + parts[i].label);
    }
    ImGui::EndGroup();
    return clicked;
}
