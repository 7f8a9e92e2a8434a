#include "ui/dialogs/file_dialog.h"

#include "gpu/input_event.h"
#include "ui/dialogs/desktop_dialog.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/file_commands.h"
#include "ui/dialogs/file_list.h"
#include "ui/dialogs/file_places.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <imgui/imgui_internal.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
/// A frame of the dialog. The browser is a copy that the user's input changes.
struct FileDialogFrame {
    const Scene& scene;
    const FileDialogKind& kind;
    FileRules rules;
    FileBrowser browser;
    std::optional<fs::path> chosen = {};       // the dialog is done
    std::vector<FolderEntry> fresh_rows = {};  // for a text that was changed in this frame

    bool has_rows() const {
        const FolderListing& listing = scene.folders.listing();
        return !scene.folders.is_reading() && listing.folder == shown_path(browser).folder;
    }
    // The entries for the text of this frame.
    const std::vector<FolderEntry>& rows() {
        const FileDialogChoices& choices = scene.window.file_dialogs;
        if (browser.text == scene.window.dialog.browser.text || !has_rows())
            return scene.folders.rows();
        fresh_rows = file_rows(scene.folders.listing(),
                               filter_of(browser, rules, choices.order, choices.shows_hidden));
        return fresh_rows;
    }
};

void start(const Scene& scene, Edits& edits) {
    edits.arrange([browser = first_browser(scene.window.dialog, scene.window.file_dialogs,
                                           scene.lab.document),
                   places = dialog_places(scene)](WindowState& window) {
        if (window.dialog.browser.folder.empty())
            window.dialog.browser = browser;
        window.dialog.places = places;
        window.dialog.is_new = false;
    });
}

void draw_folder_line(FileDialogFrame& frame, Edits& edits) {
    const fs::path folder = shown_path(frame.browser).folder;
    if (ImGui::Button("Up"))
        enter_folder(frame.browser, frame.rules, folder.parent_path());
    edits.mark("dialog_up");
    ImGui::SameLine();
    constexpr const char* hidden = "Hidden files";
    const float box = ImGui::CalcTextSize(hidden).x + ImGui::GetFrameHeight() +
                      ImGui::GetStyle().ItemInnerSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x - box - ImGui::GetFontSize();
    if (const auto clicked = draw_folder_path(folder, room, edits))
        enter_folder(frame.browser, frame.rules, *clicked);
    same_line_right(box);
    bool shows_hidden = frame.scene.window.file_dialogs.shows_hidden;
    if (ImGui::Checkbox(hidden, &shows_hidden))
        edits.arrange([shows_hidden](WindowState& window) {
            window.file_dialogs.shows_hidden = shows_hidden;
        });
    edits.mark("hidden_files");
}

std::string list_problem(const FileDialogFrame& frame) {
    if (!frame.has_rows())
        return "Reading…";
    const FolderListing& listing = frame.scene.folders.listing();
    if (!listing.problem.empty())
        return listing.problem;
    const bool is_filtered = !shown_path(frame.browser).name.empty();
    return listing.entries.empty() || !is_filtered
               ? "This folder has no matching files."
               : "No matching files. Clear the name to list all.";
}

// Takes the choice of the user: enters a folder, asks, shows a problem, or is done.
void take(FileDialogFrame& frame, const FileChoice& choice) {
    apply_choice(frame.browser, frame.rules, choice);
    if (choice.kind == FileChoice::Kind::choose)
        frame.chosen = choice.path;
}

// The picture or the length of the selected file, at the right end of wide dialogs.
void draw_preview(const Scene& scene, float width, float height, Edits& edits) {
    ImGui::SameLine();
    const ScopedColor back(ImGuiCol_ChildBg, theme::surround);
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding,
                                      ImVec2(8.0f * scene.scale, 8.0f * scene.scale));
    ImGui::BeginChild("##preview", {width, height}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    const ViewImage image = scene.pictures.file.image();
    const float room = ImGui::GetContentRegionAvail().x;
    if (image.handle != 0) {
        const auto wide = static_cast<float>(image.extent.width);
        const auto high = static_cast<float>(image.extent.height);
        const float size = std::min(room / wide, room / high);
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + (room - wide * size) * 0.5f);
        ImGui::Image(texture_id(image.handle), {wide * size, high * size}, {0.0f, 1.0f},
                     {1.0f, 0.0f});
        edits.mark("file_picture");
    }
    for (const std::string& line : scene.pictures.file.lines()) {
        wrapped_dim_text(line);
        edits.mark("file_facts");
    }
    if (scene.pictures.file.lines().empty())
        dim_text(scene.pictures.file.is_pending() ? "Reading…" : "No preview");
    ImGui::EndChild();
}

void draw_lists(FileDialogFrame& frame, float height, Edits& edits) {
    const PlaceClick place = draw_file_places(frame.rules, height, frame.scene, edits);
    if (place.folder)
        enter_folder(frame.browser, frame.rules, *place.folder);
    if (place.file)
        frame.chosen = *place.file;
    ImGui::SameLine();
    const float letter = ImGui::GetFontSize();
    const bool has_preview = ImGui::GetContentRegionAvail().x > 40.0f * letter;
    const float preview = has_preview ? 13.0f * letter : 0.0f;
    const float gap = has_preview ? ImGui::GetStyle().ItemSpacing.x : 0.0f;
    const float width = ImGui::GetContentRegionAvail().x - preview - gap;
    const std::vector<FolderEntry>& rows = frame.rows();
    const auto click = draw_file_list({.rows = rows,
                                       .highlighted = highlighted(frame.browser, frame.rules, rows),
                                       .problem = list_problem(frame),
                                       .shows_highlighted = frame.browser.shows_selection},
                                      {width, height}, frame.scene, edits);
    if (has_preview)
        draw_preview(frame.scene, preview, height, edits);
    if (frame.has_rows())
        frame.browser.shows_selection = false;
    if (!click || !frame.has_rows())
        return;
    if (click->is_double)
        take(frame, accepted_row(frame.browser, frame.rules, click->row));
    else
        select_row(frame.browser, frame.rules, click->row);
}

// Up, Down, Page Up and Page Down select a row while the name field has the focus.
void follow_arrows(FileDialogFrame& frame) {
    constexpr int page = 10;
    int by = 0;
    for (const auto& [key, rows] : {std::pair{gpu::key::down, 1},
                                    {gpu::key::up, -1},
                                    {gpu::key::page_down, page},
                                    {gpu::key::page_up, -page}})
        by += ImGui::IsKeyPressed(key) ? rows : 0;
    if (by == 0 || !frame.has_rows())
        return;
    const std::string text = frame.browser.text;
    move_selection(frame.browser, frame.rules, frame.rows(), by);
    if (frame.browser.text != text)
        ImGui::ClearActiveID();  // otherwise the active field would keep its text
}

// The Tab key replaces the text of the active field.
int complete(ImGuiInputTextCallbackData* data) {
    auto& frame = *static_cast<FileDialogFrame*>(data->UserData);
    const std::string text(data->Buf, static_cast<std::size_t>(data->BufTextLen));
    const std::string completed = completed_path(text, frame.rows());
    if (completed != text) {
        data->DeleteChars(0, data->BufTextLen);
        data->InsertChars(0, completed.c_str());
    }
    return 0;
}

void draw_name(FileDialogFrame& frame, Edits& edits) {
    std::string text = frame.browser.text;
    // Tab completes while it can. Otherwise it goes to the next field.
    const bool can_complete =
        frame.has_rows() && completed_path(text, frame.rows()) != text && !text.empty();
    if (!ImGui::IsAnyItemActive())
        ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    const char* hint = frame.rules.is_saving ? "File name" : "Part of a name, or a path";
    if (ImGui::InputTextWithHint(
            "##file", hint, &text,
            can_complete ? ImGuiInputTextFlags_CallbackCompletion : ImGuiInputTextFlags_None,
            can_complete ? complete : nullptr, &frame))
        type_text(frame.browser, text);
    edits.mark("dialog_file");
}

// A line below the name: what is wrong with it, or what happens to an existing file.
void draw_advice(FileDialogFrame& frame, Edits& edits) {
    const NameCheck check = check_typed_name(frame.browser, frame.rules);
    const std::string& failure = frame.scene.window.dialog.problem;
    ImGui::AlignTextToFramePadding();
    if (!frame.browser.replaced.empty()) {
        const ScopedColor color(ImGuiCol_Text, theme::warning);
        ImGui::TextUnformatted(frame.browser.problem.c_str());
        edits.mark("dialog_taken");
    } else if (!frame.browser.problem.empty()) {
        draw_dialog_problem(frame.browser.problem, edits);
    } else if (!check.problem.empty()) {
        if (const auto suggestion = draw_name_advice(check, edits)) {
            ImGui::ClearActiveID();
            type_text(frame.browser, *suggestion);
        }
    } else if (frame.rules.is_saving && frame.has_rows() &&
               !frame.scene.folders.listing().is_writable) {
        draw_dialog_problem("You don't have permission to save in this folder.", edits);
    } else if (!failure.empty()) {
        draw_dialog_problem(failure, edits);
    } else {
        dim_text(frame.scene.folders.is_reading() ? "Reading the folder…" : "");
    }
}

bool can_accept(const FileDialogFrame& frame) {
    const FolderListing& listing = frame.scene.folders.listing();
    const bool is_barred = frame.rules.is_saving && frame.has_rows() && !listing.is_writable &&
                           frame.browser.selected.empty();
    return !is_barred && check_typed_name(frame.browser, frame.rules).is_valid;
}

void accept(FileDialogFrame& frame) {
    frame.browser.is_accepting = needs_rows(frame.browser, frame.rules) && !frame.has_rows();
    if (!frame.browser.is_accepting)
        take(frame, accepted(frame.browser, frame.rules, frame.rows()));
}

float height_around_lists(const FileDialogFrame& frame) {
    const ImGuiStyle& style = ImGui::GetStyle();
    return 4.0f * ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing() +
           4.0f * style.ItemSpacing.y + 2.0f * style.WindowPadding.y + 28.0f * frame.scene.scale;
}

const char* verb_of(FileDialogFrame& frame) {
    if (!frame.browser.replaced.empty())
        return "Replace";
    const auto row = std::ranges::find(frame.rows(), frame.browser.selected, &FolderEntry::name);
    const bool enters = row != frame.rows().end() && row->is_folder;
    return frame.rules.is_saving && !enters ? "Save" : "Open";
}

void draw_content(FileDialogFrame& frame, Edits& edits) {
    draw_folder_line(frame, edits);
    const float height = list_height(20.0f * ImGui::GetFontSize(), height_around_lists(frame));
    draw_lists(frame, height, edits);
    follow_arrows(frame);
    draw_name(frame, edits);
    draw_advice(frame, edits);
    draw_desktop_switch(frame.scene, edits);
    if (draw_dialog_buttons(verb_of(frame), can_accept(frame), edits) || frame.browser.is_accepting)
        accept(frame);
}
}  // namespace

void draw_file_dialog(const Scene& scene, Edits& edits) {
    const Dialog& dialog = scene.window.dialog;
    const FileDialogKind* kind = file_dialog_kind(dialog.kind);
    if (!kind)
        return close_dialog(edits);
    if (dialog.answer) {
        edits.arrange([](WindowState& window) { window.dialog.answer.reset(); });
        return finish_file_dialog(*dialog.answer, scene, edits);
    }
    if (dialog.host == Dialog::Host::desktop)
        return draw_desktop_dialog(scene, edits);
    if (dialog.host == Dialog::Host::undecided)
        return;
    if (dialog.is_new)
        return start(scene, edits);
    const DialogFrame window(kind->title, 64.0f, scene, edits);
    if (!window.is_open())
        return;
    FileDialogFrame frame{scene, *kind, rules_of(*kind), dialog.browser};
    draw_content(frame, edits);
    if (frame.browser != dialog.browser)
        edits.arrange([browser = frame.browser](WindowState& state) {
            if (state.dialog.browser.text != browser.text)
                state.dialog.problem.clear();
            state.dialog.browser = browser;
        });
    if (frame.chosen)
        finish_file_dialog(*frame.chosen, scene, edits);
}
