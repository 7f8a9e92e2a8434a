#pragma once

#include "lab/window/preset_browsing.h"
#include "ui/frame/edits.h"
#include "ui/widgets/search_box.h"

#include <string>

/// The search of the preset list and the preset browser.
void draw_preset_search(const SearchBox& box, const PresetBrowsing& wanted, Edits& edits);
/// A button that shows only favourites.
void draw_star_filter(const char* mark, const PresetBrowsing& wanted, Edits& edits);
/// The reason for an empty list.
std::string why_no_preset(const PresetBrowsing& wanted);
