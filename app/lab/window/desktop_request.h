#pragma once

#include "io/desktop/file_request.h"
#include "lab/window/file_dialog_kind.h"

#include <string>

/// The request to the desktop's dialog for a dialog of the program: the same title, files, first
/// folder and proposed name.
FileRequest desktop_request(const Dialog& dialog, const FileDialogChoices& choices,
                            const Document* document);

/// Continues the dialog with the reply. A chosen file is its answer. The program's own dialog opens
/// instead if the name is invalid, if a completed name would replace a file without a request, or
/// if the desktop's dialog failed. Returns why it failed; "": it did not.
std::string take_reply(Dialog& dialog, const FileReply& reply);
