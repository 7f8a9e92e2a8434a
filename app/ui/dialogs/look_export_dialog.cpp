#include "ui/dialogs/look_export_dialog.h"

#include "lab/editor/external_programs.h"
#include "lab/files/file_rows.h"
#include "lab/frame/pass_control.h"
#include "lab/jobs/background_jobs.h"
#include "lab/storage/local_date.h"
#include "lab/window/file_dialog_kind.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/dialog_rows.h"
#include "ui/dialogs/work_dialog.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <cctype>

namespace fs = std::filesystem;

namespace {
void find_losses(std::size_t target, Edits& edits) {
    edits.change([target](BackgroundJobs& jobs, const Document& document) {
        jobs.look_export().find_losses(document, target);
    });
}

void draw_target(LookExportForm& form, Edits& edits) {
    std::vector<std::string> labels;
    for (const ExportTarget& target : export_targets())
        labels.push_back(target.label);
    dialog_row("Format");
    const std::size_t chosen =
        dialog_list("look_export_target", labels, form.target, ImGui::GetFontSize() * 12.0f, edits);
    if (chosen != form.target) {
        form = with_target(form, chosen);
        find_losses(chosen, edits);
    }
}

void draw_place(LookExportForm& form, bool is_new, Edits& edits) {
    dialog_row(export_targets()[form.target].extension.empty() ? "Name" : "File name");
    if (is_new)
        ImGui::SetKeyboardFocusHere();
    form.file = dialog_text("dialog_file", form.file, "Name or path",
                            ImGui::GetContentRegionAvail().x, edits);
    const ScopedDisabled disabled(has_own_folder(form.file));
    dialog_row("Folder");
    form.folder = dialog_text("dialog_folder", form.folder.string(), "",
                              ImGui::GetContentRegionAvail().x, edits);
}

void draw_list(const char* label, const std::vector<std::string>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        dialog_row(i == 0 ? label : "");
        wrapped_dim_text(lines[i]);
    }
}

// Whether the look can be exported, as far as it is known.
bool draw_losses(const LookExportForm& form, const LookExporter& exporter, Edits& edits) {
    draw_list("Keeps", export_targets()[form.target].keeps);
    const auto& losses = exporter.losses().outcome();
    if (!losses) {
        draw_list("Loses", {"Checking…"});
        return false;
    }
    if (!*losses) {
        dialog_row("Problem");
        const ScopedColor color(ImGuiCol_Text, theme::warning);
        ImGui::TextWrapped("%s", losses->error().front().message.c_str());
        edits.mark("look_export_refused");
        return false;
    }
    draw_list("Loses", (*losses)->empty() ? std::vector<std::string>{"nothing"} : **losses);
    edits.mark("look_export_losses");
    return true;
}

void draw_verify(LookExportForm& form, Edits& edits) {
    static const bool has_browser = can_verify();
    const ExportTarget& target = export_targets()[form.target];
    const bool is_page = target.page != nullptr;
    const bool is_possible = target.why_not_drawn.empty() && (has_browser || !is_page);
    dialog_row("Check");
    const ScopedDisabled disabled(!is_possible);
    bool verifies = form.verifies && is_possible;
    if (ImGui::Checkbox(
            is_page ? "Draw the export in Chromium and compare" : "Draw the export and compare",
            &verifies))
        form.verifies = verifies;
    edits.mark("look_export_verify");
    if (!is_possible) {
        dialog_row("");
        wrapped_dim_text(target.why_not_drawn.empty() ? "Chromium is not installed."
                                                      : target.why_not_drawn + ".");
    }
}

void start(const LookExportSettings& settings, Edits& edits) {
    edits.change(
        [settings](BackgroundJobs& jobs, const Document& document, const PassControl& passes) {
            jobs.look_export().start(document, passes.switches(), settings);
        });
    edits.arrange([folder = settings.path.parent_path()](WindowState& window) {
        window.look_export.folder = folder;
        window.dialog.text = "started";
    });
}

void draw_form(const Scene& scene, Edits& edits) {
    const bool is_new = scene.window.dialog.is_new;
    LookExportForm form = scene.window.look_export;
    if (is_new) {
        if (form.folder.empty())
            form.folder = last_folder(scene.window.file_dialogs, "export", UserFolder::documents);
        form = initial_look_export(form, *scene.lab.document, local_date());
        find_losses(form.target, edits);
    }
    draw_target(form, edits);
    draw_place(form, is_new, edits);
    const auto settings = planned_look_export(form, scene.lab.size.extent());
    dialog_row_problem(settings ? "" : settings.error().front().message, edits);
    const bool can_export = draw_losses(form, scene.lab.jobs.look_export(), edits);
    draw_verify(form, edits);
    std::error_code ignored;
    const bool replaces = settings && fs::exists(settings->path, ignored);
    if (replaces)
        dim_text("This export exists and will be replaced.");
    edits.arrange([form](WindowState& window) {
        window.look_export = form;
        window.dialog.is_new = false;
    });
    const bool has_list = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    if (draw_dialog_buttons(replaces ? "Replace" : "Export",
                            settings.has_value() && can_export && !has_list, edits))
        start(*settings, edits);
}

void draw_result(const LookExportResult& result, Edits& edits) {
    const fs::path& path = result.made.path;
    ImGui::TextWrapped("Exported \"%s\" (%s)", path.filename().string().c_str(),
                       file_size_text(result.made.bytes).c_str());
    edits.mark("look_export_done");
    if (result.verification) {
        const bool is_good = result.verification->outcome == Verification::Outcome::verified;
        std::string text = result.verification->text;
        text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
        const ScopedColor color(ImGuiCol_Text, is_good ? theme::dim : theme::warning);
        ImGui::TextWrapped("%s", text.c_str());
        edits.mark("look_export_verification");
    }
    dim_text(path.parent_path().string());
    ImGui::Spacing();
    if (path.extension() == ".html") {
        if (ImGui::Button("Open page"))
            edits.change([path](ExternalPrograms& programs) { programs.open_page(path); });
        edits.mark("look_export_open");
        ImGui::SameLine();
    }
    if (ImGui::Button("Open folder"))
        edits.change([folder = path.parent_path()](ExternalPrograms& programs) {
            programs.open_folder(folder);
        });
}
}  // namespace

void export_look(const Scene&, Edits& edits) {
    edits.change([](BackgroundJobs& jobs) { jobs.look_export().cancel(); });
    edits.show({.kind = Dialog::Kind::export_look});
}

void draw_look_export_dialog(const Scene& scene, Edits& edits) {
    if (!scene.lab.document)
        return close_dialog(edits);
    const DialogFrame frame("Export look", 40.0f, scene, edits);
    if (!frame.is_open())
        return;
    const auto& work = scene.lab.jobs.look_export().work();
    const bool was_started = scene.window.dialog.text == "started";
    if (!was_started || (!work.is_running() && !work.outcome()))
        return draw_form(scene, edits);
    draw_work(
        work, "Exporting and comparing…",
        [&](const LookExportResult& result) { draw_result(result, edits); },
        [](BackgroundJobs& jobs) { jobs.look_export().cancel(); }, edits);
}
