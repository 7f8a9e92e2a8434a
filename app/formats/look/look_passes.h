#pragma once

#include "formats/json/object_reader.h"
#include "formats/look/look_folder.h"
#include "model/look/look.h"

#include <string_view>

/// Reads "passes" into a look whose other members are already read. Reports errors with their
/// lines.
void read_passes(ObjectReader& reader, LookFolder& folder, Look& look);

/// Reads a whole number within `limit`, or the name of a parameter.
Count read_count(ObjectReader& reader, std::string_view key, int fallback, Limit limit);

/// Reads the "filter", "wrap" and "mipmap" of an input or image.
Sampler read_sampler(ObjectReader& reader);

/// Whether a pass or an input exists for the look's driver. Reads its key `driven_by`.
bool is_for_driver(ObjectReader& reader, const Look& look);

/// Whether the name is valid for a pass or image. It becomes part of file names and of "NAME@1".
bool is_look_name(std::string_view name);
std::string_view look_name_rule();
