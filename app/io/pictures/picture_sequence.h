#pragma once

#include "io/pictures/picture_reader.h"

#include <filesystem>
#include <memory>

/// Whether a name is a pattern for numbered pictures, with %d or %04d.
bool is_sequence_name(const std::filesystem::path& name);

/// The pictures of "frame_%04d.png" from the lowest existing number to the highest. Reading a
/// missing number in between is an error.
Result<std::unique_ptr<PictureReader>> open_sequence(const std::filesystem::path& name);
