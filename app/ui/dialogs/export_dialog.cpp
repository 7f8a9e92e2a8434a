#include "ui/dialogs/export_dialog.h"

#include "lab/offline/background_jobs.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/work_dialog.h"

#include <algorithm>

namespace {
double export_seconds(const Scene& scene) {
    if (scene.window.exporting.seconds > 0.0)
        return scene.window.exporting.seconds;
    const double sound = scene.lab.player.signal().sound_seconds();
    return sound > 0.0 ? sound : film_seconds_without_sound;
}

void draw_exported(const ExportResult& exported, Edits& edits) {
    const std::string size = size_text(exported.size);
    const std::string file = exported.file.string();
    const std::string text =
        exported.frames == 1
            ? fmt::format("Exported 1 frame ({}) to {}.", size, file)
            : fmt::format("Exported {} frames ({}) to {}.", exported.frames, size, file);
    ImGui::TextUnformatted(wrapped(text, ImGui::GetContentRegionAvail().x).c_str());
    edits.mark("export_done");
    for (const Diagnostic& warning : exported.warnings)
        wrapped_dim_text(warning.message);
}
}  // namespace

void export_frames(const std::filesystem::path& file, const Scene& scene, Edits& edits) {
    ExportSettings wishes{file, scene.window.exporting.fps, scene.window.exporting.seconds};
    if (!file.has_extension())
        wishes.file += ".mp4";
    edits.change([wishes](BackgroundJobs& jobs) { jobs.export_frames(wishes); });
    edits.show({.kind = Dialog::Kind::exporting});
}

void draw_export_numbers(const Scene& scene, Edits& edits) {
    const float width = ImGui::GetFontSize() * 6.0f;
    double seconds = export_seconds(scene);
    ImGui::SetNextItemWidth(width);
    if (ImGui::InputDouble("seconds", &seconds, 0.0, 0.0, "%.3f"))
        edits.arrange([seconds](WindowState& window) {
            window.exporting.seconds = std::clamp(seconds, 0.0, 86400.0);
        });
    edits.mark("export_seconds");
    ImGui::SameLine();
    double fps = scene.window.exporting.fps;
    ImGui::SetNextItemWidth(width);
    if (ImGui::InputDouble("fps", &fps, 0.0, 0.0, "%.3f"))
        edits.arrange(
            [fps](WindowState& window) { window.exporting.fps = std::clamp(fps, 1.0, 1000.0); });
    edits.mark("export_fps");
}

void draw_export_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("Export video or image sequence", 44.0f, scene, edits);
    if (!frame.is_open())
        return;
    const auto draw = [&](const ExportResult& exported) { draw_exported(exported, edits); };
    draw_work(
        scene.lab.jobs.frame_export(), "Rendering from the start…", draw,
        [](BackgroundJobs& jobs) { jobs.cancel_export(); }, edits);
}
