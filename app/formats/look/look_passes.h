#pragma once

#include "formats/json/object_reader.h"
#include "formats/look/look_folder.h"
#include "model/look/look.h"

#include <string_view>

/// Reads "passes" into a look whose other members are read. Mistakes are noted at their lines.
void read_passes(ObjectReader& reader, LookFolder& folder, Look& look);

/// Reads the "filter", "wrap" and "mipmap" of an input or image.
Sampler read_sampler(ObjectReader& reader);

/// Whether a pass or image may have the name: it becomes part of file names and of "NAME@1".
bool is_look_name(std::string_view name);
std::string_view look_name_rule();
