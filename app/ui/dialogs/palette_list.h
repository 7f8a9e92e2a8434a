#pragma once

#include "lab/choices/palette.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <vector>

/// All that a person may ask for by name: every action, then what the lab has.
std::vector<PaletteEntry> palette_list(const Scene& scene);

/// Does what the entry says, and remembers that it was used.
void run(const PaletteEntry& entry, const Scene& scene, Edits& edits);
