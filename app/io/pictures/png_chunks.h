#pragma once

#include "base/diagnostic.h"

#include <string>
#include <string_view>
#include <vector>

/// A piece of a PNG file; its views look into the file's bytes.
struct PngChunk {
    std::string_view type;  // four letters
    std::string_view data;
    std::string_view whole;  // with length, type and check sum
};

/// Whether the bytes start as every PNG does.
bool is_png(std::string_view bytes);

/// The chunks up to IEND, in order, their check sums right. Errors carry no file.
Result<std::vector<PngChunk>> parse_png_chunks(std::string_view bytes);

/// What is wrong with the header of such chunks (PNG specification, 11.2.2), or that they hold no
/// pixels or no palette where they need one; "": nothing.
std::string fault_of_png(const std::vector<PngChunk>& chunks);

/// The bytes of a chunk: length, type, data and check sum.
std::string png_chunk(std::string_view type, std::string_view data);

/// What every PNG starts with.
std::string_view png_signature();
