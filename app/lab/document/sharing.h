#pragma once

#include "lab/document/document.h"
#include "lab/storage/media.h"
#include "model/look/picture.h"

#include <filesystem>
#include <string>

/// Records the foreign looks of a document and the files of its values as recent media. A preset
/// names them only by file name, like sounds and pictures. The list finds them again.
void remember_files(const Document& document, const RecentMedia& recent);

/// The document's values that differ from the defaults, as a preset for `file`. It names the user's
/// sound or picture relative to the folder of `file`, with a digest.
Preset portable_preset_of(const Document& document, const std::filesystem::path& file,
                          const RecentMedia& recent);

// Shared presets name the user's files only by file name and digest, without folders.

/// The document as one line of text with all values.
std::string share_line_of(const Document& document, const RecentMedia& recent);

/// Writes the document as a preset. `name` "": keeps its name, or uses the file name. Only .json is
/// accepted; save_picture_with_preset() writes PNGs.
Result<void> write_preset(const Document& document, const std::string& name,
                          const std::filesystem::path& file, const RecentMedia& recent);

/// The bytes of a PNG with the document as a preset, so that it can be opened.
Result<std::string> png_with_preset(const std::string& png, const Document& document,
                                    const RecentMedia& recent);

/// The bytes of a PNG with the document as a preset. If the look has alpha (ISF) and any pixel is
/// transparent, it has unassociated alpha.
Result<std::string> png_of(const Picture& picture, const Document& document,
                           const RecentMedia& recent);

/// Writes a picture. A PNG also contains the document as a preset, so that it can be opened; see
/// png_of().
Result<void> save_picture_with_preset(const Picture& picture, const Document& document,
                                      const std::filesystem::path& file, const RecentMedia& recent);
