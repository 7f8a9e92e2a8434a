#pragma once

#include "formats/look/loaded_look.h"

/// Whether a file is a fragment shader alone: a text with main() and no other program's marks. One
/// that is not there is told by its name.
bool is_bare_file(const std::filesystem::path& file);

/// Reads one as a look of one pass: GLSL ES 1.00 and 3.00 and desktop versions, with the names of
/// GameMaker, glslViewer, three.js, raylib and Shadertoy. What else it declares becomes parameters,
/// as in a look of our own. Errors are the includes' and glslang's, at their
/// lines.
LoadedLook load_bare_look(const std::filesystem::path& file, const IncludeFolders& includes,
                          const ReadingHelp& help);
