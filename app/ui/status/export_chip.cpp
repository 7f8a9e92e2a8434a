#include "ui/status/export_chip.h"

#include "lab/editor/external_programs.h"
#include "lab/jobs/background_jobs.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <cmath>

namespace {
constexpr const char* popup = "exports";

std::string time_left(const ExportQueue& queue) {
    const auto seconds = queue.seconds_left();
    if (!seconds)
        return {};
    return *seconds < 90.0 ? fmt::format(" · {:.0f} s left", std::ceil(*seconds))
                           : fmt::format(" · {:.0f} min left", *seconds / 60.0);
}

std::string running_text(const ExportQueue& queue) {
    const std::string name = queue.running()->file.filename().string();
    std::string text = fmt::format("Exporting {} · {:.0f} %{}",
                                   elided_to_width(name, ImGui::GetFontSize() * 14.0f),
                                   100.0 * queue.share(), time_left(queue));
    if (const int waiting = queue.pending() - 1; waiting > 0)
        text += fmt::format(" · {} waiting", waiting);
    return text;
}

std::string ended_text(const ExportQueue& queue) {
    const QueuedExport& last = queue.entries().back();
    const std::string name =
        elided_to_width(last.file.filename().string(), ImGui::GetFontSize() * 14.0f);
    if (last.state == QueuedExport::State::failed)
        return "Export failed: " + name;
    return (last.state == QueuedExport::State::done ? "Exported " : "Cancelled ") + name;
}

theme::Color color_of(const ExportQueue& queue) {
    if (queue.is_pending())
        return theme::text;
    return queue.entries().back().state == QueuedExport::State::failed ? theme::problem
                                                                       : theme::dim;
}

std::string text_of(const QueuedExport& entry) {
    switch (entry.state) {
        case QueuedExport::State::waiting:
            return "waiting";
        case QueuedExport::State::running:
            return "running";
        case QueuedExport::State::done:
            return size_text(entry.result.size);
        case QueuedExport::State::cancelled:
            return "cancelled";
        case QueuedExport::State::failed:
            break;
    }
    return entry.reasons.front().message;
}

void draw_entry(const QueuedExport& entry, Edits& edits) {
    const ScopedId id(entry.id);
    const float width = ImGui::GetFontSize() * 30.0f;
    const float buttons = ImGui::GetFontSize() * 10.0f;
    const float start = ImGui::GetCursorPosX();
    const bool is_failed = entry.state == QueuedExport::State::failed;
    ImGui::AlignTextToFramePadding();
    fitted_text(entry.file.filename().string(), width - buttons, theme::text);
    tooltip(entry.file.string());
    ImGui::SameLine(start + width - buttons);
    if (quiet_button("Open folder"))
        edits.change([folder = entry.file.parent_path()](ExternalPrograms& programs) {
            programs.open_folder(folder);
        });
    ImGui::SameLine();
    const bool is_pending =
        entry.state == QueuedExport::State::waiting || entry.state == QueuedExport::State::running;
    if (quiet_button(is_pending ? "Cancel" : "Remove"))
        edits.change([id = entry.id](BackgroundJobs& jobs) { jobs.exports().cancel(id); });
    edits.mark("export_row:" + entry.file.filename().string());
    const ScopedColor color(ImGuiCol_Text, is_failed ? theme::problem : theme::dim);
    ImGui::TextUnformatted(wrapped(text_of(entry), width).c_str());
}

void draw_list(const ExportQueue& queue, Edits& edits) {
    for (const QueuedExport& entry : queue.entries())
        draw_entry(entry, edits);
    ImGui::Separator();
    if (queue.is_pending() && ImGui::Button("Cancel all"))
        edits.change([](BackgroundJobs& jobs) { jobs.exports().cancel_all(); });
    if (queue.is_pending())
        ImGui::SameLine();
    if (ImGui::Button("Clear list"))
        edits.change([](BackgroundJobs& jobs) { jobs.exports().remove_ended(); });
    edits.mark("export_clear");
}

// A line below the last item, as long as the export is done.
void draw_progress(double share, float scale) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float height = 2.0f * scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({low.x, high.y - height}, high, theme::packed(theme::filled));
    list.AddRectFilled({low.x, high.y - height},
                       {low.x + (high.x - low.x) * static_cast<float>(share), high.y},
                       theme::packed(theme::accent));
}

// Left of the text, so that it stays in place while the text changes.
void draw_cancel(const ExportQueue& queue, float scale, Edits& edits) {
    if (quiet_button("×###cancel_export"))
        edits.change(
            [id = queue.running()->id](BackgroundJobs& jobs) { jobs.exports().cancel(id); });
    edits.mark("export_cancel");
    tooltip("Cancel this export");
    ImGui::SameLine(0.0f, 2.0f * scale);
}
}  // namespace

void draw_export_chip(const Scene& scene, Edits& edits) {
    const ExportQueue& queue = scene.lab.jobs.exports();
    if (queue.entries().empty())
        return;
    const bool is_running = queue.running() != nullptr;
    ImGui::SameLine();
    if (is_running)
        draw_cancel(queue, scene.scale, edits);
    {
        const ScopedColor color(ImGuiCol_Text, color_of(queue));
        const std::string text = is_running           ? running_text(queue)
                                 : queue.is_pending() ? "Export waiting"
                                                      : ended_text(queue);
        if (quiet_button(text + "###exports"))
            ImGui::OpenPopup(popup);
        edits.mark("export_chip");
    }
    if (is_running)
        draw_progress(queue.share(), scene.scale);
    tooltip("Click to list the exports.");
    if (ImGui::BeginPopup(popup)) {
        draw_list(queue, edits);
        ImGui::EndPopup();
    }
}
