#pragma once

#include "io/video/film_codec.h"
#include "lab/document/document.h"

#include <filesystem>

/// Whether a film has more than 8 bits per channel. False for pictures and for choices that do not
/// fit the file.
bool is_deep_film(const std::filesystem::path& file, const FilmChoice& choice);

/// Whether the look's last pass has 8 or 10 bits per channel.
bool has_few_bits(const Look& look);

/// Prepares a document for files with more than 8 bits per channel: a last pass of 8 or 10 bits
/// becomes RGBA32F, and its parameter "dither" gets its `@identity` value. If the user chose a
/// format with few bits for it, nothing changes.
void raise_precision(Document& document);

/// The drawn document with the pass formats and the dithering of the original, for the preset in a
/// picture.
Document with_precision_of(Document drawn, const Document& original);
