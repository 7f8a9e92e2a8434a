#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <optional>

/// Replaces NaN by 0 and infinities by ±65504, the largest 16-bit float. Both would spread to all
/// passes that read them, and stay in their history. Returns a warning if there were any.
std::optional<Diagnostic> sanitize(Picture& picture, const std::filesystem::path& file);

/// A picture's note as a warning; nullopt without a note.
std::optional<Diagnostic> note_about(const Picture& picture, const std::filesystem::path& file);
