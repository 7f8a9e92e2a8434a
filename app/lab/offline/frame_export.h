#pragma once

#include "base/work.h"
#include "lab/document/document.h"

#include <cstdint>
#include <filesystem>

/// How long a film is where nothing says so.
inline constexpr double film_seconds_without_sound = 10.0;

/// What a person asks to be drawn into files.
struct ExportWishes {
    std::filesystem::path file = {};  // .mp4, .webm, .gif, or .png and .exr with %04d
    double fps = 60.0;
    double seconds = 0.0;  // 0: as long as the sound, else as above

    bool operator==(const ExportWishes&) const = default;
};

/// What has come of it.
struct Exported {
    std::filesystem::path file;
    std::int64_t frames = 0;
    Extent size;
    Diagnostics warnings;
};

/// Draws a document from a fresh start with a GL context of its own, as the command render does.
/// Fails where it cannot be drawn or written, where what drives it comes but once (a microphone),
/// and when it is cancelled; then no film is left, and of pictures only whole ones.
Result<Exported> export_document(const Document& document, Extent size, const ExportWishes& wishes,
                                 Work& work);
