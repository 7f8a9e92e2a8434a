#pragma once

#include "lab/document/changes.h"

class RecentMedia;

/// The differences between a preset of the look (`before`) and the open document. Values missing in
/// the preset are defaults.
std::vector<Change> difference_from(const Preset& preset, const Document& open);

/// The same for a preset file, with its sound or picture found as on opening.
Result<std::vector<Change>> difference_from(const std::filesystem::path& preset_file,
                                            const Document& open, const RecentMedia& media);
