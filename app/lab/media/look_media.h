#pragma once

#include "base/diagnostic.h"
#include "lab/document/document.h"
#include "model/look/look.h"

#include <optional>
#include <string_view>
#include <system_error>

/// What is wrong with the pictures and sounds that a document's look brings along, and with those
/// that drive it or are chosen for its samplers: what a window would tell of them. Reads them all.
Diagnostics check_media(const Document& document);

/// The warning for a picture that cannot be read, and is black.
Diagnostic warning_of_black(Diagnostic reason, std::string_view name);

/// When a file that an image is made of was written last.
std::filesystem::file_time_type last_write_time_of(const Image& image, std::error_code& error);

/// The picture of an image of a look; nothing where a parameter chooses it. One that is not needed
/// may be unreadable: then there is nothing, and `warnings` says why.
Result<std::optional<Picture>> load_image(const Image& image, Diagnostics& warnings);
