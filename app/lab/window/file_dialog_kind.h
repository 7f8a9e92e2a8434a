#pragma once

#include "lab/files/file_browser.h"
#include "lab/files/folder_reader.h"
#include "lab/files/places.h"
#include "lab/window/dialog.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

class Document;

/// A dialog that opens or saves files.
struct FileDialogKind {
    Dialog::Kind kind;
    const char* title;
    const char* folder_key;  // dialogs with the same key share their last folder
    UserFolder first_folder;
    bool is_saving = false;
    const char* content = "Files";
    std::vector<std::string> (*extensions)() = nullptr;  // null: all files
};

/// nullptr: another kind of dialog.
const FileDialogKind* file_dialog_kind(Dialog::Kind kind);

FileRules rules_of(const FileDialogKind& kind);

/// What the user chose in file dialogs. A value; the session stores it.
struct FileDialogChoices {
    std::map<std::string, std::filesystem::path> folders = {};  // by folder_key; used last
    FileOrder order = {};
    bool shows_hidden = false;
    bool uses_desktop = true;  // the desktop's dialog, if it has one
    bool has_desktop = false;  // it has one; not stored
};

/// The last folder of the dialogs with this folder_key; otherwise that of the user.
std::filesystem::path last_folder(const FileDialogChoices& choices, const std::string& key,
                                  UserFolder otherwise);

/// The folder that the open dialog lists; nullopt: none.
std::optional<FolderRequest> folder_request(const Dialog& dialog, const FileDialogChoices& choices);

/// The file of the highlighted row; "": none, or a folder.
std::filesystem::path selected_file(const Dialog& dialog, const FolderReader& folders);

/// The first folder and name of a dialog: the last folder of its kind. A .slangp is saved next to
/// the open one, a drawing next to its file. Otherwise the desktop's folder for such files, or the
/// current folder for opening. The proposed name is valid and free. `document` may be null.
FileBrowser first_browser(const Dialog& dialog, const FileDialogChoices& choices,
                          const Document* document);
