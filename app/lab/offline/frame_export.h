#pragma once

#include "base/job_progress.h"
#include "lab/document/document.h"

#include <cstdint>
#include <filesystem>

/// The default duration of a film without sound.
inline constexpr double film_seconds_without_sound = 10.0;

/// The user's settings for an export.
struct ExportSettings {
    std::filesystem::path file = {};  // .mp4, .webm, .gif, or .png and .exr with %04d
    double fps = 60.0;
    double seconds = 0.0;  // 0: the duration of the sound, else the default

    bool operator==(const ExportSettings&) const = default;
};

/// The result of an export.
struct ExportResult {
    std::filesystem::path file;
    std::int64_t frames = 0;
    Extent size;
    Diagnostics warnings;
};

/// Draws a document from a fresh start in its own GL context, like the command render. Fails if it
/// cannot be drawn or written, if its input is live, or when cancelled. Then no film remains, and
/// only complete pictures.
Result<ExportResult> export_document(const Document& document, Extent size,
                                     const ExportSettings& wishes, JobProgress& work);
