#pragma once

#include "lab/document/changes.h"

class Lab;

/// What the open document has otherwise than a preset of its look: `before` is the preset's, what
/// it does not say counts as its default.
std::vector<Change> difference_from(const Preset& preset, const Document& open);

/// The same for a preset's file, with a sound or picture that it names found as it would be when
/// opened.
Result<std::vector<Change>> difference_from(const std::filesystem::path& preset_file,
                                            const Lab& lab);
