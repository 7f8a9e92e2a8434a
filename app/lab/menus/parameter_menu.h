#pragma once

#include "lab/document/document.h"
#include "lab/messages/menu_entry.h"
#include "lab/previews/variant_sheet.h"
#include "lab/window/parameter_list.h"
#include "lab/window/window_state.h"

/// The commands for the revealed parameter, except changing its value.
std::vector<MenuSection> parameter_sections(const Document& document, const Parameter& parameter);

/// The filters of the parameter list, groups to reset, and what Randomise changes.
std::vector<MenuSection> parameter_list_sections(const Document& document,
                                                 const WindowState& window);

/// The sheet settings and the values of its cells. `selected` can be used as an axis; null: no
/// parameter.
MenuSection sheet_section(const SheetRequest& request, const std::vector<SweepCell>& cells,
                          const Parameter* selected);

/// Draws the sheet and shows its panel.
std::vector<Edit> sheet_commands(const SheetRequest& request);

/// Whether Randomise changes a parameter of the group.
bool can_be_randomised(const Look& look, const ParameterGroup& group);
/// Randomises the unlocked parameters of the group; see model/tuning/randomised.h.
Edit randomise_group(const ParameterGroup& group, double strength);

/// Whether a filmstrip of it can be drawn.
bool can_be_varied(const Parameter& parameter);

inline constexpr std::array sheet_counts{3, 5, 7, 9, 11, 15};
