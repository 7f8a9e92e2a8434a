#include "lab/window/file_dialog_kind.h"

#include "formats/pack/pack_format.h"
#include "io/video/video_file.h"
#include "lab/document/document.h"
#include "lab/document/output_name.h"
#include "lab/library/open.h"
#include "lab/storage/media.h"
#include "lab/storage/name_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <variant>

namespace fs = std::filesystem;

namespace {
using DialogKind = Dialog::Kind;
using Extensions = std::vector<std::string>;

Extensions media_and_looks() {
    Extensions all{".svg", ".svgz", ".obj"};
    for (const Extensions& extensions :
         {picture_extensions(), sound_extensions(), video_extensions(), look_extensions()})
        all.insert(all.end(), extensions.begin(), extensions.end());
    return all;
}

Extensions reference_pictures() {
    return {".png", ".exr", ".jpg", ".jpeg", ".hdr", ".tif", ".tiff", ".bmp", ".webp"};
}

Extensions photos() {
    return {".jpg", ".jpeg", ".png", ".tif", ".tiff", ".heic", ".heif", ".webp",
            ".dng", ".nef",  ".cr2", ".cr3", ".arw",  ".raf",  ".orf"};
}

// The first extension is added to names without one.
const std::array file_dialogs{
    FileDialogKind{.kind = DialogKind::open_file,
                   .title = "Open a look, shader, preset, picture or sound",
                   .folder_key = "open",
                   .first_folder = UserFolder::documents,
                   .content = "Looks, presets, pictures and sounds",
                   .extensions = media_and_looks},
    FileDialogKind{.kind = DialogKind::choose_file,
                   .title = "Choose a file",
                   .folder_key = "input",
                   .first_folder = UserFolder::pictures},
    FileDialogKind{.kind = DialogKind::choose_reference,
                   .title = "Choose a reference picture",
                   .folder_key = "reference",
                   .first_folder = UserFolder::pictures,
                   .content = "Pictures",
                   .extensions = reference_pictures},
    FileDialogKind{.kind = DialogKind::choose_photo,
                   .title = "Choose a photo of a tube",
                   .folder_key = "photo",
                   .first_folder = UserFolder::pictures,
                   .content = "Photos",
                   .extensions = photos},
    FileDialogKind{.kind = DialogKind::choose_shown,
                   .title = "Choose the picture that the photo shows",
                   .folder_key = "input",
                   .first_folder = UserFolder::pictures,
                   .content = "Pictures",
                   .extensions = [] { return Extensions(picture_extensions()); }},
    FileDialogKind{.kind = DialogKind::load_drawing,
                   .title = "Load drawing",
                   .folder_key = "drawing",
                   .first_folder = UserFolder::pictures,
                   .content = "Drawings",
                   .extensions =
                       [] {
                           return Extensions{".svg", ".svgz"};
                       }},
    FileDialogKind{.kind = DialogKind::save_pass,
                   .title = "Save pass (EXR: exact values, PNG: as shown)",
                   .folder_key = "picture",
                   .first_folder = UserFolder::pictures,
                   .is_saving = true,
                   .content = "Passes",
                   .extensions =
                       [] {
                           return Extensions{".exr", ".png"};
                       }},
    FileDialogKind{.kind = DialogKind::save_drawing,
                   .title = "Save drawing",
                   .folder_key = "drawing",
                   .first_folder = UserFolder::pictures,
                   .is_saving = true,
                   .content = "Drawings",
                   .extensions = [] { return Extensions{".svg"}; }},
    FileDialogKind{.kind = DialogKind::save_automation,
                   .title = "Save automation file (for afterglow render --moves)",
                   .folder_key = "automation",
                   .first_folder = UserFolder::documents,
                   .is_saving = true,
                   .content = "Automation files",
                   .extensions = [] { return Extensions{".txt"}; }},
    FileDialogKind{.kind = DialogKind::open_cues,
                   .title = "Open a cue file",
                   .folder_key = "cues",
                   .first_folder = UserFolder::documents,
                   .content = "Cue files",
                   .extensions = [] { return Extensions{".txt"}; }},
    FileDialogKind{.kind = DialogKind::save_cues,
                   .title = "Save cue file (for afterglow render --cues)",
                   .folder_key = "cues",
                   .first_folder = UserFolder::documents,
                   .is_saving = true,
                   .content = "Cue files",
                   .extensions = [] { return Extensions{".txt"}; }},
    FileDialogKind{.kind = DialogKind::save_slangp,
                   .title = "Save changed parameters as .slangp (references the original)",
                   .folder_key = "slangp",
                   .first_folder = UserFolder::documents,
                   .is_saving = true,
                   .content = "RetroArch presets",
                   .extensions = [] { return Extensions{".slangp"}; }},
    FileDialogKind{.kind = DialogKind::save_pack,
                   .title = "Save the look and its presets as a pack",
                   .folder_key = "pack",
                   .first_folder = UserFolder::documents,
                   .is_saving = true,
                   .content = "Packs",
                   .extensions = [] { return Extensions{std::string(pack_extension)}; }}};

// The file of a drawing or sound that is the signal; "": it has none.
fs::path signal_file(const Document& document) {
    const auto& settings = document.state().signal.settings;
    const auto file = settings.find("file");
    const auto* text = file == settings.end() ? nullptr : std::get_if<std::string>(&file->second);
    return text ? fs::path(*text) : fs::path();
}

// The folder next to which the document's file belongs; "": any.
fs::path folder_of_document(DialogKind kind, const Document& document) {
    if (kind == DialogKind::save_slangp)
        return document.look().manifest.parent_path();
    if (kind == DialogKind::save_drawing)
        return signal_file(document).parent_path();
    return {};
}

}  // namespace

fs::path last_folder(const FileDialogChoices& choices, const std::string& key,
                     UserFolder otherwise) {
    const auto last = choices.folders.find(key);
    return last != choices.folders.end() && is_folder(last->second)
               ? last->second
               : user_folder(otherwise, home_folder());
}

namespace {
fs::path first_folder(const FileDialogKind& kind, const FileDialogChoices& choices,
                      const Document* document) {
    if (const fs::path own = document ? folder_of_document(kind.kind, *document) : fs::path();
        is_folder(own))
        return fs::absolute(own);
    const auto last = choices.folders.find(kind.folder_key);
    if (last != choices.folders.end() && is_folder(last->second))
        return last->second;
    std::error_code error;
    fs::path current = fs::current_path(error);
    if (!kind.is_saving && is_folder(current) && current != current.root_path())
        return current;
    return user_folder(kind.first_folder, home_folder());
}

// Without characters that separate folders, such as "crt/mask" in a stack.
std::string file_stem(std::string name) {
    std::ranges::replace(name, '/', '-');
    return valid_preset_name(name);
}

std::string proposed_stem(const Dialog& dialog, const Document* document) {
    switch (dialog.kind) {
        case DialogKind::save_pass:
            return file_stem(dialog.subject);
        case DialogKind::save_drawing:
            return "drawing";
        case DialogKind::save_pack:
            return file_stem(document ? document->look().id : std::string());
        case DialogKind::save_automation:
            return "automation";
        case DialogKind::save_cues:
            return "cues";
        case DialogKind::save_slangp:
            return file_stem(document ? document->look().name : std::string()) + "-mine";
        default:
            return {};
    }
}
}  // namespace

const FileDialogKind* file_dialog_kind(Dialog::Kind kind) {
    const auto found = std::ranges::find(file_dialogs, kind, &FileDialogKind::kind);
    return found == file_dialogs.end() ? nullptr : &*found;
}

FileRules rules_of(const FileDialogKind& kind) {
    return {.is_saving = kind.is_saving,
            .opens_looks = kind.kind == DialogKind::open_file,
            .extensions = kind.extensions ? kind.extensions() : Extensions(),
            .content = kind.content};
}

std::optional<FolderRequest> folder_request(const Dialog& dialog,
                                            const FileDialogChoices& choices) {
    const FileDialogKind* kind = file_dialog_kind(dialog.kind);
    if (!kind || dialog.is_new || dialog.host != Dialog::Host::own)
        return std::nullopt;
    const FileRules rules = rules_of(*kind);
    return FolderRequest{shown_path(dialog.browser).folder, rules.extensions,
                         filter_of(dialog.browser, rules, choices.order, choices.shows_hidden)};
}

fs::path selected_file(const Dialog& dialog, const FolderReader& folders) {
    const FileDialogKind* kind = file_dialog_kind(dialog.kind);
    if (!kind || folders.listing().folder.empty())
        return {};
    const std::string name = highlighted(dialog.browser, rules_of(*kind), folders.rows());
    const auto row = std::ranges::find(folders.rows(), name, &FolderEntry::name);
    const bool is_file = row != folders.rows().end() && !row->is_folder;
    return is_file ? folders.listing().folder / name : fs::path();
}

FileBrowser first_browser(const Dialog& dialog, const FileDialogChoices& choices,
                          const Document* document) {
    const FileDialogKind* kind = file_dialog_kind(dialog.kind);
    if (!kind)
        return {};
    FileBrowser browser{.folder = first_folder(*kind, choices, document)};
    std::string stem = proposed_stem(dialog, document);
    if (kind->is_saving && stem.empty())
        stem = "untitled";
    if (kind->is_saving)
        browser.text = unused_name(browser.folder, stem, rules_of(*kind).extensions.front());
    return browser;
}
