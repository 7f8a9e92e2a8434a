#pragma once

#include "lab/document/document.h"
#include "lab/storage/media.h"
#include "model/look/picture.h"

#include <filesystem>
#include <string>

/// Remembers the looks of other programs that a document is made of, and the files that its values
/// choose. A preset names such a look by its file's name alone, as it does sounds and pictures, and
/// it is found again in the same way. What the values choose is not asked for again.
void remember_files(const Document& document, const RecentMedia& recent);

// What leaves the machine names a person's sound or picture by its file name and digest alone.

/// The document as one line of text that holds every value.
std::string share_line_of(const Document& document, const RecentMedia& recent);

/// Writes the document as a preset; `name` "" keeps the present one, or takes the file's.
/// Only .json is a preset's file; a PNG comes from save_picture_with_preset.
Result<void> write_preset(const Document& document, const std::string& name,
                          const std::filesystem::path& file, const RecentMedia& recent);

/// Writes a picture; a PNG also carries the document as a preset, so that it opens as one. Where
/// alpha is meant as such (ISF) and is below 1 anywhere, the PNG has it, unassociated.
Result<void> save_picture_with_preset(const Picture& picture, const Document& document,
                                      const std::filesystem::path& file, const RecentMedia& recent);
