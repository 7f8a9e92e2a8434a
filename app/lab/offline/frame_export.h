#pragma once

#include "base/job_progress.h"
#include "io/video/film_codec.h"
#include "lab/document/document.h"
#include "model/tuning/cue_plan.h"

#include <cstdint>
#include <filesystem>
#include <memory>

/// The default duration of a film without sound.
inline constexpr double film_seconds_without_sound = 10.0;

/// The video that a look processes at its own speed; "": none.
std::filesystem::path source_video(const Document& document);

/// The user's settings for an export.
struct ExportSettings {
    std::filesystem::path file = {};  // a film, or .png and .exr with %04d
    Extent size = {};                 // empty: the render size
    double fps = 60.0;
    double start = 0.0;    // s
    double seconds = 0.0;  // 0: the duration of the sound, else the default
    FilmChoice film = {};
    bool draws_subframes = false;  // each is a frame
    bool loops = false;            // one period; `seconds` is its length, 0: find it

    bool operator==(const ExportSettings&) const = default;
};

/// The result of an export.
struct ExportResult {
    std::filesystem::path file;
    std::int64_t frames = 0;  // 0: a single picture
    Extent size;
    Diagnostics warnings;
};

/// A document to draw, and its cues.
struct CuedDocument {
    Document document;
    std::shared_ptr<const CuePlan> cues = {};  // null: none

    CuePlan plan() const { return cues ? *cues : CuePlan{}; }
};

/// Whether the document draws sound that is played, or the beam of another program.
bool draws_live_signal(const Document& document);

/// Fails if the document can't be exported to this file: live input, a file type that is not known,
/// a codec that does not fit, a folder that can't be written. Draws nothing.
Result<void> check_export(const Document& document, const ExportSettings& settings);

/// Draws a document with its cues from a fresh start in its own GL context, like the command
/// render. Fails if it cannot be drawn or written, or when cancelled. Then no film remains, and
/// only complete pictures.
Result<ExportResult> export_document(const CuedDocument& cued, Extent size,
                                     const ExportSettings& settings, JobProgress& work);
