#pragma once

#include "formats/cues/cue_sheet.h"
#include "lab/library/library.h"
#include "model/tuning/cue_plan.h"

/// The plan of a cue sheet for a look, with values checked and presets read. Errors, each at its
/// line: unknown parameters and presets, invalid values. Signal, source and tempo of a preset are
/// not changed; parameters that can't be used in a cue stay as they are. `presets` gets the files
/// of the presets.
Result<CuePlan> plan_cues(const CueSheet& sheet, const std::filesystem::path& file,
                          const Look& look, const Library& library,
                          std::vector<std::filesystem::path>& presets);
/// The same for a file.
Result<CuePlan> load_cue_plan(const std::filesystem::path& file, const Look& look,
                              const Library& library);
/// Fails if a cue can't be played with a look, for these reasons.
Result<void> check_cue(const Cue& cue, const Look& look, const Library& library);
