#pragma once

#include "formats/look/loaded_look.h"

#include <filesystem>
#include <string>

/// The look.json of a look that is named by its folder or by that file.
std::filesystem::path manifest_of(const std::filesystem::path& folder_or_manifest);

/// Reads a look: its manifest, its shaders with their includes, and its parameters, all checked.
/// `folder_or_manifest` is the look's folder, its look.json or a foreign file (of libretro, ISF,
/// Shadertoy, or a fragment shader alone); `includes` where its includes may lie besides.
LoadedLook load_look(const std::filesystem::path& folder_or_manifest,
                     const IncludeFolders& includes, const ReadingHelp& help = {});

/// Whether a file is a look of another program, by its name or, where many kinds of file have it,
/// by what it holds.
bool is_foreign_look(const std::filesystem::path& file);

/// The id of the look in a folder, manifest or foreign file, from its name alone.
std::string look_id_at(const std::filesystem::path& place);
