#include "ui/dialogs/recent_files.h"

#include "lab/storage/display_name.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <set>

namespace fs = std::filesystem;

std::vector<fs::path> recent_files(const Scene& scene, const std::vector<std::string>& extensions) {
    std::vector<fs::path> files;
    for (const std::string& name : scene.window.recent.files) {
        const fs::path file(name);
        std::string ending = file.extension().string();
        std::ranges::transform(ending, ending.begin(), [](unsigned char letter) {
            return static_cast<char>(std::tolower(letter));
        });
        std::error_code ignored;
        const bool fits = extensions.empty() || std::ranges::count(extensions, ending) > 0;
        if (fits && fs::is_regular_file(file, ignored))
            files.push_back(file);
    }
    return files;
}

std::optional<fs::path> draw_recent_files(const std::vector<fs::path>& files, Edits& edits) {
    std::optional<fs::path> clicked;
    for (const fs::path& file : files) {
        ImGui::PushID(file.c_str());
        const float width = ImGui::GetContentRegionAvail().x;
        if (ImGui::Selectable(elided_to_width(display_name(file), width).c_str(), false,
                              ImGuiSelectableFlags_DontClosePopups))
            clicked = file;
        edits.mark("recent:" + file.filename().string());
        tooltip(file.string());
        ImGui::PopID();
    }
    return clicked;
}
