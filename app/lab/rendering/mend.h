#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <optional>

/// Makes 0 of what is no number and 65504, the largest 16-bit float, of what is infinite: either
/// would spread over all that reads it, and stay in what remembers. Says so when there was any.
std::optional<Diagnostic> mend(Picture& picture, const std::filesystem::path& file);

/// A picture's note as a warning; nothing where it has none.
std::optional<Diagnostic> note_about(const Picture& picture, const std::filesystem::path& file);
