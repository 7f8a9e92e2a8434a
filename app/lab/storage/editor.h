#pragma once

#include "base/diagnostic.h"

#include <string>
#include <vector>

/// The command that opens a place in the user's editor ($VISUAL, else $EDITOR, else what the
/// desktop opens text with), with the line in the form that this editor knows. A terminal's editor
/// is given one. The variable is split as split_command says; the file's path is absolute. Fails
/// where the place has no file, or the variable is not a command.
Result<std::vector<std::string>> editor_command(const Location& place);

/// Starts it, and does not wait.
Result<void> open_in_editor(const Location& place);

/// Shows a folder in the desktop's file manager, and does not wait.
Result<void> open_folder(const std::filesystem::path& folder);
