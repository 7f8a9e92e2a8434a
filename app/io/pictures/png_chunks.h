#pragma once

#include "base/diagnostic.h"

#include <string>
#include <string_view>
#include <vector>

/// A chunk of a PNG file; its views refer to the file's bytes.
struct PngChunk {
    std::string_view type;  // four letters
    std::string_view data;
    std::string_view whole;  // with length, type and checksum
};

/// Whether the bytes start with the PNG signature.
bool is_png(std::string_view bytes);

/// The chunks up to IEND, in order, with verified checksums. Errors have no file.
Result<std::vector<PngChunk>> parse_png_chunks(std::string_view bytes);

/// The error in the header of these chunks (PNG specification, 11.2.2), or missing pixels or a
/// missing palette; "" if valid.
std::string fault_of_png(const std::vector<PngChunk>& chunks);

/// The bytes of a chunk: length, type, data and checksum.
std::string png_chunk(std::string_view type, std::string_view data);

std::string_view png_signature();
