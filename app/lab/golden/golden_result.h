#pragma once

#include "lab/golden/golden_item.h"
#include "lab/golden/golden_record.h"

#include <optional>
#include <string>
#include <vector>

/// The states of a golden picture, in the order of the report.
enum class GoldenStatus {
    different,
    broken,    // the look or preset has errors
    missing,   // there is no golden picture
    orphaned,  // there is no look or preset
    created,
    updated,
    removed,
    skipped,  // not comparable
    equal,    // within the bounds
};

/// "different".
const char* name_of(GoldenStatus status);
/// Whether the check fails.
bool is_failure(GoldenStatus status);

/// The comparison of a look or preset with its golden picture.
struct GoldenResult {
    GoldenItem item;
    GoldenStatus status = GoldenStatus::equal;
    std::string note = {};     // why; "" if the numbers explain it
    std::string command = {};  // that writes or removes the picture; "": not needed
    Extent size = {};
    int frames = 0;
    std::optional<Difference> difference = {};  // in levels of 255
    double gain = 1.0;                          // of `difference_png`
    // PNG files; "": none. Without a difference there is only the golden picture.
    std::string golden_png = {};
    std::string new_png = {};
    std::string difference_png = {};
    Diagnostics problems = {};  // errors and warnings of the look or preset
};

/// The result of a run.
struct GoldenOutcome {
    std::vector<GoldenResult> results = {};  // by status, then by name
    GoldenBounds bounds = {};
    GoldenDriver driver = {};
    Diagnostics warnings = {};

    bool has_failed() const;
    int count(GoldenStatus status) const;
};

/// "different: 2, equal: 5", without states that do not occur.
std::string counts_text(const GoldenOutcome& outcome);
/// "max 34/255, 2.1 % of pixels beyond 2/255"; "" without a difference.
std::string difference_text(const GoldenResult& result, const GoldenBounds& bounds);
