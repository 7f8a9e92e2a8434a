#include "ui/dialogs/still_dialog.h"

#include "lab/document/output_name.h"
#include "lab/jobs/background_jobs.h"
#include "lab/offline/export_plan.h"
#include "lab/sequencer/sequencer.h"
#include "lab/storage/local_date.h"
#include "lab/views/snapshot.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/dialog_rows.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
void draw_file(StillForm& form, bool is_new, Edits& edits) {
    const auto& formats = still_formats();
    const float format_width = ImGui::GetFontSize() * 9.0f;
    dialog_row("File name");
    if (is_new)
        ImGui::SetKeyboardFocusHere();
    form.file = dialog_text(
        "dialog_file", form.file, "Name or path",
        ImGui::GetContentRegionAvail().x - format_width - ImGui::GetStyle().ItemSpacing.x, edits);
    const auto typed =
        std::ranges::find(formats, fs::path(form.file).extension().string(), &StillFormat::ending);
    const auto current = static_cast<std::size_t>(form.format);
    if (typed != formats.end() && typed->ending != formats[current].ending)
        form.format = static_cast<int>(typed - formats.begin());
    ImGui::SameLine();
    std::vector<std::string> labels;
    for (const StillFormat& format : formats)
        labels.push_back(format.label);
    const auto before = static_cast<std::size_t>(form.format);
    const std::size_t chosen = dialog_list("still_format", labels, before, format_width, edits);
    if (chosen != before) {
        form.format = static_cast<int>(chosen);
        form.file = fs::path(form.file).replace_extension(formats[chosen].ending).string();
    }
    const ScopedDisabled disabled(has_own_folder(form.file));
    dialog_row("Folder");
    form.folder = dialog_text("dialog_folder", form.folder.string(), "",
                              ImGui::GetContentRegionAvail().x, edits);
}

void draw_size(StillForm& form, Extent render_size, const Look& look, Edits& edits) {
    const auto& sizes = still_sizes();
    std::vector<std::string> labels;
    for (const std::string& size : sizes)
        labels.push_back(fmt::format("{} ({})", size, size_text(still_extent(size, render_size))));
    const auto current = std::ranges::find(sizes, form.size);
    const auto before = static_cast<std::size_t>(current - sizes.begin());
    dialog_row("Size");
    const std::size_t chosen =
        dialog_list("still_size", labels, before, ImGui::GetFontSize() * 16.0f, edits);
    if (chosen < sizes.size())
        form.size = sizes[chosen];
    if (const std::string note = still_note(form, look); !note.empty()) {
        dialog_row("");
        dim_text(note);
    }
}

// A slow look whose frame is unfinished has no whole picture to save.
bool is_drawn_again(const StillForm& form, const Scene& scene) {
    return scene.window.hdr.is_on || form.size != "1x" || !scene.lab.renderer ||
           !scene.lab.renderer->has_whole_picture();
}

void save(const StillSettings& settings, bool is_drawn_again, Edits& edits) {
    close_dialog(edits);
    edits.arrange([folder = settings.file.parent_path()](WindowState& window) {
        window.saving.folder = folder;
        window.file_dialogs.folders["picture"] = folder;
    });
    if (is_drawn_again)
        return edits.change([settings](const PassControl& passes, const Sequencer& sequencer,
                                       BackgroundJobs& jobs) {
            StillSettings drawn = settings;
            drawn.switches = passes.switches();
            jobs.export_still(drawn, sequencer.cues().plan());
        });
    edits.change([settings](const Renderer& renderer, const PassControl& passes,
                            const Sequencer& sequencer, BackgroundJobs& jobs, Messages& messages) {
        if (auto picture = snapshot(renderer, passes.picture_pass(), messages))
            jobs.save_still(std::move(*picture), sequencer.drawn_document(), settings);
    });
}
}  // namespace

void draw_still_dialog(const Scene& scene, Edits& edits) {
    if (!scene.lab.document)
        return close_dialog(edits);
    const DialogFrame frame("Save picture", 38.0f, scene, edits);
    if (!frame.is_open())
        return;
    const bool is_new = scene.window.dialog.is_new;
    StillForm form = scene.window.saving;
    const auto is_taken = [&](const fs::path& file) { return scene.lab.jobs.is_target(file); };
    if (is_new) {
        if (form.folder.empty())
            form.folder = last_folder(scene.window.file_dialogs, "picture", UserFolder::pictures);
        form = initial_still_form(form, *scene.lab.document, local_date(), is_taken);
    }
    const Extent render_size = scene.lab.size.extent();
    draw_file(form, is_new, edits);
    draw_size(form, render_size, scene.lab.document->look(), edits);
    const auto settings =
        planned_still(form, render_size, scene.lab.player.transport().time(), is_taken);
    dialog_row_problem(settings ? "" : settings.error().front().message, edits);
    wrapped_dim_text(still_formats()[static_cast<std::size_t>(form.format)].help);
    std::error_code ignored;
    const bool replaces = settings && fs::exists(settings->file, ignored);
    if (replaces)
        dim_text("This file exists and will be replaced.");
    edits.arrange([form](WindowState& window) {
        window.saving = form;
        window.dialog.is_new = false;
    });
    const bool has_list = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    if (draw_dialog_buttons(replaces ? "Replace" : "Save", settings.has_value() && !has_list,
                            edits))
        save(*settings, is_drawn_again(form, scene), edits);
}
