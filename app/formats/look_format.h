#pragma once

#include "formats/look/loaded_look.h"

#include <filesystem>
#include <string>

/// The look.json of a look that is given by its folder or by that file.
std::filesystem::path manifest_of(const std::filesystem::path& folder_or_manifest);

/// Loads and checks a look: its manifest, its shaders with their includes, and its parameters.
/// `folder_or_manifest` is the look's folder, its look.json, or a foreign file (libretro, ISF,
/// Shadertoy, or a single fragment shader). `includes` are additional include folders.
LoadedLook load_look(const std::filesystem::path& folder_or_manifest,
                     const IncludeFolders& includes, const LoadOptions& help = {});

/// Whether a file is a look of another program, by its extension or, for ambiguous extensions, by
/// its content.
bool is_foreign_look(const std::filesystem::path& file);

/// The stack with a source picture or a signal as its driver, if that is possible for one of its
/// looks; otherwise unchanged. Reads their look.json.
Stack with_driver(Stack stack, bool is_picture_driven);

/// The id of the look in a folder, manifest or foreign file, from the path only.
std::string look_id_at(const std::filesystem::path& path);
