#pragma once

#include "base/diagnostic.h"
#include "model/look.h"

#include <optional>
#include <string_view>

/// What is wrong with the pictures and sounds that a look brings along, and with the test pattern
/// that it starts with. Reads them all.
Diagnostics check_media(const Look& look);

/// Whether an Image::made or a parameter that chooses a picture names one of the program's own; its
/// name alone.
std::optional<std::string_view> made_name(std::string_view choice);
/// What they name then.
Result<Picture> made_picture(const std::string& name);

/// The picture of an image of a look; nothing where a parameter chooses it. One that is not needed
/// may be unreadable: then there is nothing, and `warnings` says why.
Result<std::optional<Picture>> load_image(const Image& image, Diagnostics& warnings);
