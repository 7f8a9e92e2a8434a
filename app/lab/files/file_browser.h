#pragma once

#include "lab/files/file_rows.h"
#include "lab/files/typed_path.h"
#include "lab/storage/name_check.h"

#include <filesystem>
#include <string>
#include <vector>

/// What a file dialog accepts.
struct FileRules {
    bool is_saving = false;
    bool opens_looks = false;                  // a folder with look.json is chosen, not entered
    std::vector<std::string> extensions = {};  // lower case; empty: all files
    std::string content = "Files";             // for messages: "Pictures"

    FileNameRule names() const { return {extensions, content}; }
};

/// The state of a file dialog: a folder, the typed text and the selected row. A value.
struct FileBrowser {
    std::filesystem::path folder = {};    // absolute; typed names are relative to it
    std::string text = {};                // a name, part of a name, or a path
    std::string selected = {};            // the row chosen by arrow keys or mouse; "": none
    std::string problem = {};             // shown below the text
    std::filesystem::path replaced = {};  // the dialog asks whether to replace this file
    bool is_accepting = false;            // Enter was pressed while the folder was being read
    bool shows_selection = false;         // the list scrolls to the highlighted row

    bool operator==(const FileBrowser&) const = default;
};

/// The folder that is listed, which a typed path can change, and the typed name in it.
TypedPath shown_path(const FileBrowser& browser);

/// Which entries of that folder are listed. The typed name filters unless a file is being saved.
FileFilter filter_of(const FileBrowser& browser, const FileRules& rules, const FileOrder& order,
                     bool shows_hidden);

/// The name of the highlighted row: the selected one, otherwise the first one that matches the
/// typed name; "": none.
std::string highlighted(const FileBrowser& browser, const FileRules& rules,
                        const std::vector<FolderEntry>& rows);

/// Changes the typed text. A message or a question about the previous text ends.
void type_text(FileBrowser& browser, std::string text);

/// Selects a row. A selected file becomes the text if a file is being saved.
void select_row(FileBrowser& browser, const FileRules& rules, const FolderEntry& row);

/// Selects the row `by` rows further; without a highlighted row, the first or the last one.
void move_selection(FileBrowser& browser, const FileRules& rules,
                    const std::vector<FolderEntry>& rows, int by);

/// Lists another folder. The name of a file to be saved stays.
void enter_folder(FileBrowser& browser, const FileRules& rules,
                  const std::filesystem::path& folder);

/// What the dialog does when the user presses Enter, or double-clicks a row.
struct FileChoice {
    enum class Kind { nothing, enter_folder, choose, ask_to_replace, fail };

    Kind kind = Kind::nothing;
    std::filesystem::path path = {};
    std::string problem = {};

    bool operator==(const FileChoice&) const = default;
};

/// The choice of the Enter key. A typed name or path that exists has priority, then the highlighted
/// row. Reads the file system.
FileChoice accepted(const FileBrowser& browser, const FileRules& rules,
                    const std::vector<FolderEntry>& rows);

/// Whether accepted() depends on the rows, so that it has to wait while they are being read.
bool needs_rows(const FileBrowser& browser, const FileRules& rules);

/// The choice of a double click on a row.
FileChoice accepted_row(const FileBrowser& browser, const FileRules& rules, const FolderEntry& row);

/// Whether the typed name can be saved. Always valid when opening.
NameCheck check_typed_name(const FileBrowser& browser, const FileRules& rules);

/// Applies a choice to the dialog itself: enters a folder, asks, or shows a problem.
void apply_choice(FileBrowser& browser, const FileRules& rules, const FileChoice& choice);
