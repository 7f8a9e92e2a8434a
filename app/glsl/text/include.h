#pragma once

#include "model/look/include_folders.h"
#include "model/look/look.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

class ShaderFiles;

/// Folders that an #include may read from, besides the including file's own.
struct IncludeRoots {
    std::filesystem::path look_folder;  // "": the folder of the file that is loaded
    IncludeFolders folders;
    // Of `#include <NAME>`, which stay in the text as they are: what they bring is given elsewhere.
    std::span<const std::string_view> given = {};
    std::filesystem::path tree = {};  // the folder that was opened; "": opened_tree()
};

/// The folder within which the includes of a file may go upwards: the nearest one above it that
/// holds `.git` or `look.json`, else the one above its own. Absolute; links are not followed.
std::filesystem::path opened_tree(const std::filesystem::path& file);

/// Reads `file` and everything it includes. Includes are looked for beside the including file, in
/// the look's folder, in `include/` beside it, in the shared folder and in the named ones. All that
/// is included lies in one of these or in the opened tree, by its path: a link counts where it
/// stands. It has an extension of shader text, also where links lead to. `#pragma once` is obeyed,
/// `#line` is blanked out.
/// `files` gets every file that was read, or looked for and missing (for a watcher), also on
/// failure. Errors name the including line; several at once. `disk`, which may be null, is shared
/// by the stages of one reading.
Result<Stage> load_stage(const std::filesystem::path& file, const IncludeRoots& roots,
                         std::vector<std::filesystem::path>& files, ShaderFiles* disk = nullptr);

/// A stage made from a text of the program's own (no includes).
Stage builtin_stage(std::string text);

/// The program's own vertex shader for `fullscreen` passes without one: one triangle, `out vec2
/// uv`, (0,0) bottom left.
const Stage& fullscreen_vertex_stage();
