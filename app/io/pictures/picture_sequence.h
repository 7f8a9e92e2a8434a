#pragma once

#include "io/pictures/picture_reader.h"

#include <filesystem>
#include <memory>

/// Whether a name stands for numbered pictures: it holds %d or %04d.
bool is_sequence_name(const std::filesystem::path& name);

/// The pictures of "frame_%04d.png" from the lowest number that is there to the highest. A number
/// that is missing in between is a problem when it is asked for.
Result<std::unique_ptr<PictureReader>> open_sequence(const std::filesystem::path& name);
