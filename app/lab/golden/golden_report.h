#pragma once

#include "lab/golden/golden_request.h"
#include "lab/golden/golden_result.h"

/// Writes the HTML report of a run next to the golden pictures. It contains its pictures, so that
/// it opens without a network and from a disk. Text is escaped. Atomic.
Result<void> save_golden_report(const GoldenRequest& request, const GoldenOutcome& outcome);
