#pragma once

#include "lab/golden/golden_request.h"
#include "lab/golden/golden_result.h"
#include "lab/library/library.h"

#include <functional>

/// Draws the looks and presets of a folder and compares them with their golden pictures, or writes
/// the pictures and golden.json. Presets find looks in the folder, then among those of the program.
/// Fails if nothing can be drawn or a file can't be written; errors of single looks are results.
/// `progress` gets the number of finished pictures and that of all.
Result<GoldenOutcome> check_golden(const GoldenRequest& request, const Library& library,
                                   const std::function<void(int done, int all)>& progress);
