#pragma once

#include "base/diagnostic.h"
#include "lab/storage/roots.h"

#include <string>
#include <vector>

/// An editor, and the command that opens a file in it.
struct EditorInfo {
    std::string name;     // "Visual Studio Code"
    std::string command;  // "code --goto {file}:{line}"
};

/// The known editors with a program in $PATH.
std::vector<EditorInfo> installed_editors();

/// The command that opens a location in the user's editor: the chosen command, then $VISUAL, then
/// $EDITOR, then xdg-open. It is split by split_command(). "{file}" becomes the absolute path and
/// "{line}" the line; without "{file}" both are passed in the editor's own form. Terminal editors
/// without "{file}" are started in a terminal. Fails if the location has no file, or the command is
/// not valid.
Result<std::vector<std::string>> editor_command(const Location& location,
                                                const std::string& chosen = {});

/// The command that the user chose; "": none.
std::string load_editor(const Roots& roots);
Result<void> save_editor(const Roots& roots, const std::string& command);
