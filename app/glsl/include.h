#pragma once

#include "model/look.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

class ShaderFiles;

/// Folders that an #include may read from, besides the including file's own.
struct IncludeRoots {
    std::filesystem::path look_folder;  // "": the folder of the file that is loaded
    std::filesystem::path shared;       // the program's shaders/include
    // Of `#include <NAME>`, which stay in the text as they are: what they bring is given elsewhere.
    std::span<const std::string_view> given = {};
};

/// Reads `file` and everything it includes. Includes are looked for beside the including file, in
/// the look's folder, in `include/` beside it, and in the shared folder; all that is read lies in
/// one of these, also when links are followed. `#pragma once` is obeyed, `#line` is blanked out.
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
