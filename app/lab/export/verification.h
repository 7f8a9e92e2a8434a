#pragma once

#include "base/job_progress.h"
#include "lab/export/export_target.h"

/// The result of redrawing an export with another program.
struct Verification {
    enum class Outcome { verified, not_verified, failed };

    Outcome outcome = Outcome::not_verified;
    std::string text;  // "verified: max 1/255, 0.02 % of pixels differ"
};

/// Whether Chromium is installed.
bool can_verify();

/// Draws a look and what was exported of it, and compares the last frames: up to 60, at most
/// 640x360 pixels. Chromium draws pages. Other files are opened as looks, and the source has 8
/// bits. Verified means at most 1/255 in 99.9 % of the pixels and 3/255 anywhere. Needs GL.
/// `seconds`: timeout of the browser. `work`: null, or its progress.
Verification verify_export(const ExportTarget& target, const ExportRequest& request, double seconds,
                           JobProgress* work = nullptr);
