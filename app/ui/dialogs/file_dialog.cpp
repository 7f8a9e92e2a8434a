#include "ui/dialogs/file_dialog.h"

#include "lab/commands/content_commands.h"
#include "lab/commands/preset_commands.h"
#include "lab/document/automation.h"
#include "lab/drawing/drawing_tool.h"
#include "lab/library/open.h"
#include "lab/views/snapshot.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/recent_files.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <imgui/imgui_internal.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
std::vector<std::string> endings_for(Dialog::Kind kind) {
    if (kind == Dialog::Kind::save_picture)
        return {".png", ".exr"};
    if (kind == Dialog::Kind::save_pass)
        return {".exr", ".png"};
    if (kind == Dialog::Kind::export_frames)
        return {".mp4", ".webm", ".gif", ".png", ".exr"};
    if (kind == Dialog::Kind::load_drawing)
        return {".svg", ".svgz"};
    if (kind == Dialog::Kind::save_drawing)
        return {".svg"};
    if (kind == Dialog::Kind::save_automation)
        return {".txt"};
    if (kind == Dialog::Kind::choose_file)
        return {};
    if (kind == Dialog::Kind::choose_reference)
        return {".png", ".exr", ".jpg", ".jpeg", ".hdr", ".tif", ".tiff", ".bmp", ".webp"};
    std::vector<std::string> all{".svg",  ".svgz", ".obj",  ".png",  ".exr", ".jpg",
                                 ".jpeg", ".wav",  ".flac", ".ogg",  ".oga", ".mp3",
                                 ".aif",  ".aiff", ".mp4",  ".m4v",  ".mkv", ".webm",
                                 ".mov",  ".avi",  ".mpg",  ".mpeg", ".ogv", ".gif"};
    for (std::string& extension : look_extensions())
        all.push_back(std::move(extension));
    return all;
}

const char* title_for(Dialog::Kind kind) {
    switch (kind) {
        case Dialog::Kind::save_picture:
            return "Save picture";
        case Dialog::Kind::save_pass:
            return "Save pass (EXR: exact values, PNG: as shown)";
        case Dialog::Kind::export_frames:
            return "Export video (.mp4, .webm, .gif) or image sequence (frame_%04d.png, .exr)";
        case Dialog::Kind::load_drawing:
            return "Load drawing";
        case Dialog::Kind::save_drawing:
            return "Save drawing";
        case Dialog::Kind::save_automation:
            return "Save automation file (for afterglow render --moves)";
        case Dialog::Kind::save_slangp:
            return "Save changed parameters as .slangp (references the original)";
        case Dialog::Kind::choose_file:
            return "Choose a file";
        case Dialog::Kind::choose_reference:
            return "Choose a reference picture";
        default:
            return "Open a look, shader, preset, picture or sound";
    }
}

// Value of `Dialog::chosen` after an arrow key: scroll to the entry and focus the name field.
constexpr int shows_chosen = 1;

bool is_saving(const Dialog& dialog) {
    return dialog.kind == Dialog::Kind::save_picture || dialog.kind == Dialog::Kind::save_pass ||
           dialog.kind == Dialog::Kind::save_drawing ||
           dialog.kind == Dialog::Kind::save_automation ||
           dialog.kind == Dialog::Kind::save_slangp || dialog.kind == Dialog::Kind::export_frames;
}

void enter(const fs::path& folder, Edits& edits) {
    edits.arrange([folder = folder.lexically_normal()](WindowState& window) {
        window.dialog.folder = folder;
        window.dialog.entries = list_folder(folder, endings_for(window.dialog.kind));
        window.recent.folder = folder;
    });
}

void start(const Scene& scene, Edits& edits) {
    std::error_code error;
    const fs::path& last = scene.window.recent.folder;
    enter(fs::is_directory(last, error) ? last : fs::current_path(error), edits);
    edits.arrange([](WindowState& window) { window.dialog.is_new = false; });
    if (scene.window.dialog.kind == Dialog::Kind::save_picture)
        edits.arrange([](WindowState& window) { window.dialog.text = "picture.png"; });
    if (scene.window.dialog.kind == Dialog::Kind::export_frames)
        edits.arrange([](WindowState& window) { window.dialog.text = "video.mp4"; });
    if (scene.window.dialog.kind == Dialog::Kind::save_pass)
        edits.arrange([](WindowState& window) {
            window.dialog.text = window.dialog.subject + ".exr";
            std::ranges::replace(window.dialog.text, '/', '-');  // "crt/mask" in a stack
        });
    if (scene.window.dialog.kind == Dialog::Kind::save_drawing)
        edits.arrange([](WindowState& window) { window.dialog.text = "drawing.svg"; });
    if (scene.window.dialog.kind == Dialog::Kind::save_automation)
        edits.arrange([](WindowState& window) { window.dialog.text = "automation.txt"; });
    if (scene.window.dialog.kind == Dialog::Kind::save_slangp)
        edits.arrange([name = scene.lab.document->look().name](WindowState& window) {
            window.dialog.text = name + "-mine.slangp";
        });
}

void finish(const fs::path& file, const Scene& scene, Edits& edits) {
    const Dialog& dialog = scene.window.dialog;
    close_dialog(edits);
    if (dialog.kind == Dialog::Kind::open_file)
        edits.open_file(file);
    else if (dialog.kind == Dialog::Kind::save_picture)
        edits.change([file](const Document& document, const Renderer& renderer,
                            const PassControl& passes, const MediaInput& media,
                            Messages& messages) {
            save_snapshot({renderer, passes.picture_pass(), document, media.recent()}, file,
                          messages);
        });
    else if (dialog.kind == Dialog::Kind::export_frames)
        export_frames(file, scene, edits);
    else if (dialog.kind == Dialog::Kind::save_pass)
        edits.change([view = scene.window.views.inspected, file](const Renderer& renderer,
                                                                 Messages& messages) {
            save_target(renderer, view, file, messages);
        });
    else if (dialog.kind == Dialog::Kind::load_drawing)
        edits.change([file](DrawingTool& drawing) { drawing.load(file); });
    else if (dialog.kind == Dialog::Kind::choose_reference)
        edits.change([file](ComparisonView& comparison) { comparison.compare_with_file(file); });
    else if (dialog.kind == Dialog::Kind::save_drawing)
        edits.change([file](DrawingTool& drawing) { drawing.save(file); });
    else if (dialog.kind == Dialog::Kind::save_automation)
        edits.change([file](Automation& automation) { automation.save(file); });
    else if (dialog.kind == Dialog::Kind::save_slangp)
        edits.change([file](PresetCommands& presets) { presets.sharing().save_slang(file); });
    else
        edits.change([name = dialog.subject, file](ContentCommands& content) {
            content.choose_picture(name, file);
        });
}

void draw_folder_line(const Dialog& dialog, Edits& edits) {
    if (ImGui::Button("Up"))
        enter(dialog.folder.parent_path(), edits);
    ImGui::SameLine();
    std::string folder = dialog.folder.string();
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::InputText("##folder", &folder, ImGuiInputTextFlags_EnterReturnsTrue))
        enter(folder, edits);
    edits.mark("dialog_folder");
}

bool is_listed(const Dialog& dialog, const std::string& name) {
    const std::string ending = endings_for(dialog.kind).empty() ? "" : endings_for(dialog.kind)[0];
    return std::any_of(dialog.entries.begin(), dialog.entries.end(), [&](const FolderEntry& entry) {
        return !entry.is_folder && (entry.name == name || entry.name == name + ending);
    });
}

// Opens a folder in the list. The folder of a look is opened as a look.
void accept(const fs::path& path, const Scene& scene, Edits& edits) {
    std::error_code ignored;
    const bool is_folder = fs::is_directory(path, ignored);
    const bool is_look = scene.window.dialog.kind == Dialog::Kind::open_file &&
                         fs::exists(path / "look.json", ignored);
    if (!is_folder || is_look)
        return finish(path, scene, edits);
    enter(path, edits);
    edits.arrange([](WindowState& window) { window.dialog.text.clear(); });
}

// Up and Down select an entry of the list while the name field has the focus.
void follow_arrows(const Dialog& dialog, Edits& edits) {
    const int by = ImGui::IsKeyPressed(gpu::key::down) ? 1
                   : ImGui::IsKeyPressed(gpu::key::up) ? -1
                                                       : 0;
    const int count = static_cast<int>(dialog.entries.size());
    if (by == 0 || count == 0)
        return;
    const auto current = std::ranges::find(dialog.entries, dialog.text, &FolderEntry::name);
    const int at =
        current == dialog.entries.end()
            ? (by > 0 ? 0 : count - 1)
            : std::clamp(static_cast<int>(current - dialog.entries.begin()) + by, 0, count - 1);
    ImGui::ClearActiveID();  // otherwise the active field would keep its text
    edits.arrange([name = dialog.entries[static_cast<std::size_t>(at)].name](WindowState& window) {
        window.dialog.text = name;
        window.dialog.chosen = shows_chosen;
    });
}

// The recent files, next to the entries of the folder. Click to open one.
void draw_recent(const Scene& scene, Edits& edits) {
    const Dialog& dialog = scene.window.dialog;
    if (is_saving(dialog))
        return;
    const std::vector<fs::path> files = recent_files(scene, endings_for(dialog.kind));
    if (files.empty())
        return;
    const float letter = ImGui::GetFontSize();
    const ScopedColor back(ImGuiCol_ChildBg, theme::surround);
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(6.0f, 6.0f));
    ImGui::BeginChild("##recent", {letter * 14.0f, letter * 20.0f}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding);
    dim_text("Recent");
    const auto clicked = draw_recent_files(files, edits);
    ImGui::EndChild();
    if (clicked)
        finish(*clicked, scene, edits);
    ImGui::SameLine();
}

// Double-click on look.json opens its folder as a look.
void draw_entries(const Scene& scene, Edits& edits) {
    const Dialog& dialog = scene.window.dialog;
    const ScopedColor back(ImGuiCol_ChildBg, theme::surround);
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(6.0f, 6.0f));
    ImGui::BeginChild("##entries", {0.0f, ImGui::GetFontSize() * 20.0f}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding);
    for (const FolderEntry& entry : dialog.entries) {
        const std::string label = entry.is_folder ? entry.name + "/" : entry.name;
        const ScopedColor color(ImGuiCol_Text, entry.is_folder ? theme::label : theme::text);
        if (ImGui::Selectable(
                label.c_str(), entry.name == dialog.text,
                ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups)) {
            if (entry.is_folder)
                enter(dialog.folder / entry.name, edits);
            else
                edits.arrange(
                    [name = entry.name](WindowState& window) { window.dialog.text = name; });
            if (!entry.is_folder && ImGui::IsMouseDoubleClicked(0))
                finish(dialog.folder / entry.name, scene, edits);
        }
        edits.mark("file:" + entry.name);
        if (dialog.chosen == shows_chosen && entry.name == dialog.text)
            ImGui::SetScrollHereY();
    }
    if (dialog.entries.empty() && !dialog.is_new)
        dim_text("This folder has no matching files.");
    ImGui::EndChild();
}
}  // namespace

void draw_file_dialog(const Scene& scene, Edits& edits) {
    const Dialog& dialog = scene.window.dialog;
    const DialogFrame frame(title_for(dialog.kind), 44.0f, scene, edits);
    if (!frame.is_open())
        return;
    if (dialog.is_new)
        start(scene, edits);
    draw_folder_line(dialog, edits);
    draw_recent(scene, edits);
    draw_entries(scene, edits);
    follow_arrows(dialog, edits);
    std::string name = dialog.text;
    ImGui::SetNextItemWidth(-1.0f);
    if (dialog.is_new || dialog.chosen == shows_chosen)
        ImGui::SetKeyboardFocusHere();
    if (dialog.chosen == shows_chosen)
        edits.arrange([](WindowState& window) { window.dialog.chosen = 0; });
    if (ImGui::InputTextWithHint("##file", "File name or path", &name))
        edits.arrange([name](WindowState& window) { window.dialog.text = name; });
    edits.mark("dialog_file");
    if (dialog.kind == Dialog::Kind::export_frames)
        draw_export_numbers(scene, edits);
    const bool replaces = is_saving(dialog) && is_listed(dialog, name);
    if (replaces)
        dim_text("This file exists and will be replaced.");
    const char* verb = replaces ? "Replace" : is_saving(dialog) ? "Save" : "Open";
    if (draw_dialog_buttons(verb, !name.empty(), edits))
        accept(dialog.folder / name, scene, edits);
}
