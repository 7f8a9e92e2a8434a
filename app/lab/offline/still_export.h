#pragma once

#include "base/job_progress.h"
#include "lab/document/document.h"
#include "lab/offline/frame_export.h"
#include "lab/storage/media.h"
#include "model/picture/raw_picture.h"
#include "model/plan/pass_switches.h"

#include <filesystem>
#include <string>
#include <vector>

/// A file format for single pictures: one row of still_formats().
struct StillFormat {
    std::string label;
    std::string ending;
    int bits = 8;  // per channel, of PNG
    std::string help;
};
const std::vector<StillFormat>& still_formats();

/// What to save, and how.
struct StillSettings {
    std::filesystem::path file;  // .png, .exr or .avif
    int png_bits = 8;
    Extent size = {};
    double seconds = 0.0;  // of the picture on the look's clock
    PassSwitches switches = {};
};

/// Fails if the file's name or folder does not fit.
Result<void> check_still(const std::filesystem::path& file);

/// Writes a picture of the document. A PNG also contains the document as a preset, and has alpha if
/// the look has it and any pixel is transparent.
Result<void> save_still(const RawPicture& picture, const Document& document,
                        const StillSettings& settings, const RecentMedia& recent);

/// Whether the file of a picture stores display values with more than 8 bits per channel.
bool is_deep_still(const StillSettings& settings);

/// Draws the document with its cues at a time and in a size, in its own GL context, and saves it.
/// The look starts empty some frames earlier, so that it has settled by then. Bypassed passes and
/// the displayed pass are those of `settings`.
Result<ExportResult> export_still(const CuedDocument& cued, const StillSettings& settings,
                                  const Roots& roots, JobProgress& work);
