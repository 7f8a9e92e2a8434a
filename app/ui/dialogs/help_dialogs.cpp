#include "ui/dialogs/help_dialogs.h"

#include "lab/commands/help_page.h"
#include "lab/editor/external_programs.h"
#include "lab/storage/version.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <array>

namespace {
/// The article that a look is based on.
struct Article {
    const char* look;
    const char* title;
};

constexpr std::array articles{
    Article{"Phosphor", "Building a Multi-Pass Phosphor Rendering Pipeline in WebGL"},
    Article{"CRT", "CRT post-process"},
    Article{"Vector beam", "Simulating an XY oscilloscope on the GPU (m1el)"},
    Article{"Caffeine", "Caffeine path tracing demo & tutorial"},
    Article{"Shadow mask", "Complex CRT, a WGSL sample with an article"},
};

void draw_folder(const char* what, const std::filesystem::path& folder, Edits& edits) {
    const ScopedId id{std::string(what)};
    dim_text(what);
    const float button = ImGui::CalcTextSize("Open").x + ImGui::GetFontSize();
    fitted_text(folder.string(),
                ImGui::GetContentRegionAvail().x - 2.0f * button - ImGui::GetFontSize() * 2.0f,
                theme::text);
    same_line_right(2.0f * button + ImGui::GetStyle().ItemSpacing.x);
    if (ImGui::Button("Open", {button, 0.0f}))
        edits.change([folder](ExternalPrograms& programs) {
            std::error_code error;
            std::filesystem::create_directories(folder, error);
            programs.open_folder(folder);
        });
    edits.mark(std::string("about_open:") + what);
    ImGui::SameLine();
    if (ImGui::Button("Copy", {button, 0.0f}))
        edits.copy(folder.string());
}

void draw_articles() {
    dim_text("The looks are based on these articles");
    if (!ImGui::BeginTable("##articles", 2, ImGuiTableFlags_SizingFixedFit))
        return;
    for (const Article& article : articles) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(article.look);
        ImGui::TableNextColumn();
        dim_text(article.title);
    }
    ImGui::EndTable();
}
}  // namespace

void draw_about_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("About Afterglow", 40.0f, scene, edits);
    if (!frame.is_open())
        return;
    ImGui::TextWrapped(
        "A lab for CRT, phosphor and oscilloscope looks. Open a look, feed it sound or pictures, "
        "tune its parameters, edit its shaders and share the result as a preset.");
    ImGui::Spacing();
    ImGui::TextUnformatted(fmt::format("Version {}. MIT License.", program_version()).c_str());
    edits.mark("about_version");
    ImGui::Spacing();
    draw_folder("Shipped looks and presets", scene.roots.program, edits);
    draw_folder("Your looks and presets", scene.roots.user, edits);
    draw_folder("Your keys", scene.roots.config, edits);
    ImGui::Spacing();
    draw_articles();
    draw_close_button("Close", edits);
}
