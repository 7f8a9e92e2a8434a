#pragma once

#include "base/diagnostic.h"
#include "lab/document/document.h"
#include "model/look/look.h"

#include <optional>
#include <string_view>
#include <system_error>

/// The problems of a look's pictures and sounds, its signal or source, and the files of its
/// samplers, as the window reports them. Reads all files.
Diagnostics check_media(const Document& document);

/// The warning for an unreadable picture, which is shown black.
Diagnostic warning_of_black(Diagnostic reason, std::string_view name);

/// The latest modification time of an image's files.
std::filesystem::file_time_type last_write_time_of(const Image& image, std::error_code& error);

/// The picture of a look's image; nullopt: a parameter chooses it. If an optional image is not
/// readable, nullopt with the reason in `warnings`.
Result<std::optional<Picture>> load_image(const Image& image, Diagnostics& warnings);
