#pragma once

#include "model/look/include_folders.h"
#include "model/look/look.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

class ShaderFiles;

/// Folders from which an #include may read, in addition to the including file's folder.
struct IncludeRoots {
    std::filesystem::path look_folder;  // "": the folder of the loaded file
    IncludeFolders folders;
    // Names of `#include <NAME>` that stay in the text; their content comes from another source.
    std::span<const std::string_view> given = {};
    std::filesystem::path tree = {};  // the folder opened by the user; "": opened_tree()
};

/// The top folder that a file's includes may reach with `..`. The nearest parent folder that
/// contains `.git` or `look.json`; otherwise the parent of the file's folder. Absolute; does not
/// follow links.
std::filesystem::path opened_tree(const std::filesystem::path& file);

/// Loads `file` and everything it includes.
/// Search order: the including file's folder, the look's folder, `include/` next to it, the shared
/// folder, the named folders. Each included path must be in one of these or in the opened tree; a
/// link counts by its own path. The file and the target of a link must have a shader extension.
/// Applies `#pragma once`; blanks out `#line`.
/// `files` receives every file that was read or was missing (for a watcher), also on failure.
/// Errors, possibly several, name the including line. `disk` (may be null) is shared by the stages
/// of one reading.
Result<Stage> load_stage(const std::filesystem::path& file, const IncludeRoots& roots,
                         std::vector<std::filesystem::path>& files, ShaderFiles* disk = nullptr);

/// The stage with another line after its #version, such as a #define. Errors in it are reported at
/// the #version.
Stage with_line_after_version(const Stage& stage, std::string_view line);

/// A stage from a built-in text without includes.
Stage builtin_stage(std::string text);

/// The built-in vertex shader for `fullscreen` passes without their own: one triangle, `out vec2
/// uv`, (0,0) at the bottom left.
const Stage& fullscreen_vertex_stage();
