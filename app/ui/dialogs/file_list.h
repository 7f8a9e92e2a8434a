#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <imgui/imgui.h>

#include <optional>

/// The rows of a file dialog, as displayed in this frame.
struct FileList {
    const std::vector<FolderEntry>& rows;
    std::string highlighted;         // name of the highlighted row; "": none
    std::string problem;             // why there are no rows; "": none
    bool shows_highlighted = false;  // scrolls to the highlighted row
};

/// What the user did in the list.
struct FileListClick {
    FolderEntry row;
    bool is_double = false;
};

/// Draws the entries of a folder with columns for name, size and date. A click on a heading sorts
/// by it.
std::optional<FileListClick> draw_file_list(const FileList& list, const ImVec2& size,
                                            const Scene& scene, Edits& edits);
