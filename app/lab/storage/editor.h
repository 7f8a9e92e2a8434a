#pragma once

#include "base/diagnostic.h"

#include <string>
#include <vector>

/// The command that opens a location in the user's editor: $VISUAL, then $EDITOR, then xdg-open.
/// The line is passed in the editor's own form. Terminal editors are started in a terminal. The
/// variable is split by split_command(); the path is absolute. Fails if the location has no file,
/// or the variable is not a valid command.
Result<std::vector<std::string>> editor_command(const Location& location);

/// Starts the editor without waiting for it.
Result<void> open_in_editor(const Location& location);

/// Opens a folder in the desktop's file manager without waiting for it.
Result<void> open_folder(const std::filesystem::path& folder);
