#pragma once

#include "lab/library/library.h"

#include <filesystem>
#include <string>

/// The PNG that a file manager shows for a file, 240 x 135 px or that of a look.png. A look or
/// preset is drawn, unless its folder has a look.png. Of a pack, it is a thumbnail in the pack:
/// nothing of it is drawn.
Result<std::string> file_thumbnail(const std::filesystem::path& file, const Library& library);
