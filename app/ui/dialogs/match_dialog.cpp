#include "ui/dialogs/match_dialog.h"

#include "lab/commands/matched_preset.h"
#include "lab/jobs/background_jobs.h"
#include "lab/match/match_report.h"
#include "lab/media/media_input.h"
#include "lab/messages/messages.h"
#include "ui/dialogs/corner_editor.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/dialog_rows.h"
#include "ui/dialogs/work_dialog.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <cmath>

namespace {
constexpr float width = 66.0f;  // in font sizes
constexpr const char* picture_hint =
    "Take the photo in the dark, sharp and not overexposed, while the tube shows the source. A "
    "triad of mask stripes must be at least 3 px wide.";
constexpr const char* beam_hint =
    "Take the photo in the dark, sharp and not overexposed, while the tube shows a straight line "
    "or a dot. The line must be at least 8 px wide.";

void choose_file(Dialog::Kind kind, Edits& edits) {
    edits.show({.kind = kind});
}

// A file name and a button that chooses another file.
void draw_file_row(const char* label, const std::string& name, const char* mark, Dialog::Kind kind,
                   Edits& edits) {
    dialog_row(label);
    const ImGuiStyle& style = ImGui::GetStyle();
    constexpr const char* choose = "Choose…";
    const float button = ImGui::CalcTextSize(choose).x + 2.0f * style.FramePadding.x;
    ImGui::AlignTextToFramePadding();
    fitted_text(name, ImGui::GetContentRegionAvail().x - button - style.ItemSpacing.x, theme::text);
    same_line_right(button);
    const ScopedId id(mark);
    if (ImGui::Button(choose))
        choose_file(kind, edits);
    edits.mark(mark);
}

std::string shown_source(const Scene& scene) {
    return std::filesystem::path(driving_file(*scene.lab.document)).filename().string();
}

void draw_problem(const Diagnostics& problems, Edits& edits) {
    const ScopedColor color(ImGuiCol_Text, theme::warning);
    ImGui::TextWrapped("%s", problems.front().message.c_str());
    edits.mark("match_problem");
}

// Photo, source and corners.
void draw_setup(const PhotoMatcher& matcher, const Scene& scene, Edits& edits) {
    const auto& photo = matcher.photo();
    draw_file_row("Photo", photo ? photo->file.filename().string() : "Drop a photo here",
                  "match_choose_photo", Dialog::Kind::choose_photo, edits);
    const bool has_beam = scene.lab.document->look().driven_by == Driver::signal;
    if (!has_beam)
        draw_file_row("Source", shown_source(scene), "match_choose_source",
                      Dialog::Kind::choose_shown, edits);
    if (matcher.reading().is_running())
        dim_text("Reading the photo…");
    else if (const auto& read = matcher.reading().outcome(); read && !*read)
        draw_problem(read->error(), edits);
    if (photo) {
        draw_corner_editor(matcher, edits);
        wrapped_dim_text(std::string("Drag the corners so that each line touches the middle of its "
                                     "side of the screen. On curved glass, they lie outside.") +
                         (photo->has_edges ? " They were guessed from the straight edges." : ""));
    } else {
        wrapped_dim_text(has_beam ? beam_hint : picture_hint);
    }
    if (draw_dialog_buttons("Match", photo.has_value() && !matcher.is_running(), edits, "Close"))
        edits.change([](BackgroundJobs& jobs) { jobs.matcher().start(); });
}

void draw_picture(const gpu::Texture& texture, const char* text, float across) {
    const Extent extent = texture.extent();
    ImGui::BeginGroup();
    dim_text(text);
    ImGui::Image(
        texture_id(texture.handle()),
        {across, across * static_cast<float>(extent.height) / static_cast<float>(extent.width)},
        {0.0f, 1.0f}, {1.0f, 0.0f});
    ImGui::EndGroup();
}

void draw_pictures(const PhotoMatcher& matcher, Edits& edits) {
    const auto& shown = matcher.shown();
    if (!shown)
        return;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float across = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2.0f);
    draw_picture(shown->photo, "Photo, straightened", across);
    ImGui::SameLine();
    draw_picture(shown->seen, "Look, as the camera would see it", across);
    edits.mark("match_pictures");
}

void draw_running(const PhotoMatcher& matcher, Edits& edits) {
    const auto& shown = matcher.shown();
    draw_pictures(matcher, edits);
    dim_text(shown ? fmt::format("{}: difference {:.2f} % of white", shown->stage,
                                 100.0 * shown->residual)
                   : std::string("Matching…"));
    edits.mark("match_stage");
    if (ImGui::Button("Stop"))
        edits.change([](BackgroundJobs& jobs) { jobs.matcher().stop(); });
    edits.mark("match_stop");
}

void cell(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

void draw_numbers(const MatchJobResult& result, const Scene& scene, Edits& edits) {
    const ScopedColor stripe(ImGuiCol_TableRowBgAlt, theme::field);
    if (!ImGui::BeginTable("##numbers", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit))
        return;
    ImGui::TableSetupColumn("Parameter");
    ImGui::TableSetupColumn("Value");
    ImGui::TableSetupColumn("90 % interval");
    ImGui::TableSetupColumn("Not identifiable", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableHeadersRow();
    for (const auto& [parameter, label] : result.types) {
        cell(parameter);
        cell(label);
        cell("");
        cell("");
    }
    for (const FoundNumber& number : result.matched.numbers) {
        cell(found_label(number, scene.lab.document->look()));
        edits.mark("match:" + number.parameter);
        cell(fmt::format("{:.4g}", number.value));
        cell(result.matched.is_complete ? fmt::format("{:.4g} – {:.4g}", number.low, number.high)
                                        : std::string("–"));
        ImGui::TableNextColumn();
        fitted_text(number.why_not, ImGui::GetContentRegionAvail().x, theme::dim);
    }
    ImGui::EndTable();
}

void apply(BackgroundJobs& jobs, Document& document) {
    jobs.matcher().apply(document);
}

void save_as_preset(BackgroundJobs& jobs, Document& document, PresetCommands& presets,
                    Messages& messages) {
    save_matched_preset(jobs.matcher(), document, presets, messages);
}

void draw_result(const MatchJobResult& result, const PhotoMatcher& matcher, const Scene& scene,
                 Edits& edits) {
    draw_pictures(matcher, edits);
    draw_numbers(result, scene, edits);
    if (result.matched.is_complete)
        wrapped_dim_text(explained_text(result.matched));
    dim_text(fmt::format("Difference {:.2f} % of white. {} pictures of {} were drawn.",
                         100.0 * result.matched.residual, result.matched.pictures,
                         size_text(result.size)));
    if (ImGui::Button("Save as preset")) {
        edits.change(save_as_preset);
        close_dialog(edits);
    }
    edits.mark("match_save");
    ImGui::SameLine();
    if (ImGui::Button("Change corners"))
        edits.change([](BackgroundJobs& jobs) { jobs.matcher().cancel(); });
    edits.mark("match_back");
    ImGui::SameLine();
    if (draw_dialog_buttons("Apply", true, edits, "Close")) {
        edits.change(apply);
        close_dialog(edits);
    }
}

void draw_failed(const Diagnostics& problems, const PhotoMatcher& matcher, Edits& edits) {
    draw_problem(problems, edits);
    draw_corner_editor(matcher, edits);
    if (matcher.better_corners()) {
        if (ImGui::Button("Use these corners"))
            edits.change([](BackgroundJobs& jobs) { jobs.matcher().take_better_corners(); });
        edits.mark("match_better");
    }
    if (draw_dialog_buttons("Match", true, edits, "Close"))
        edits.change([](BackgroundJobs& jobs) { jobs.matcher().start(); });
}
}  // namespace

void draw_match_dialog(const Scene& scene, Edits& edits) {
    if (!scene.lab.document)
        return close_dialog(edits);
    const DialogFrame frame("Match a photo", width, scene, edits);
    if (!frame.is_open())
        return;
    const PhotoMatcher& matcher = scene.lab.jobs.matcher();
    const auto& outcome = matcher.work().outcome();
    if (matcher.work().is_running())
        draw_running(matcher, edits);
    else if (outcome && *outcome && (*outcome)->look == scene.lab.document->look().id)
        draw_result(**outcome, matcher, scene, edits);
    else if (outcome && !*outcome && matcher.photo())
        draw_failed(outcome->error(), matcher, edits);
    else
        draw_setup(matcher, scene, edits);
}

void open_dropped(const std::filesystem::path& file, const Scene& scene, Edits& edits) {
    if (scene.window.dialog.kind == Dialog::Kind::match_photo)
        edits.change([file](BackgroundJobs& jobs) { jobs.matcher().open_photo(file); });
    else
        edits.open_file(file);
}
