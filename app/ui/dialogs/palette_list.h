#pragma once

#include "lab/menus/palette.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <vector>

/// All palette entries: every action, then the menu entries of the lab.
std::vector<PaletteEntry> palette_list(const Scene& scene);

/// Why an action is disabled; "": enabled.
const char* disabled_reason(const Action& action, const Scene& scene);

/// Runs the entry and records its use.
void run(const PaletteEntry& entry, const Scene& scene, Edits& edits);
