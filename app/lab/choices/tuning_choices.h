#pragma once

#include "lab/document/document.h"
#include "lab/messages/choice.h"
#include "lab/trials/variant_sheet.h"
#include "lab/window/window_state.h"

/// What can be done about the parameter that a person has in hand, beside turning it.
std::vector<ChoiceList> knob_choices(const Document& document, const Parameter& parameter);

/// Which parameters are listed, and groups of them to reset.
std::vector<ChoiceList> listing_choices(const Document& document, const WindowState& window);

/// Shows what is laid out along a slider, or two. `in_hand`: may become one of them; null: none.
ChoiceList sheet_choices(const SheetRequest& request, const std::vector<SweepCell>& cells,
                         const Parameter* in_hand);

/// Draws that, and shows its pane.
Deeds sheet_deeds(const SheetRequest& request);

/// Whether small pictures can be laid out along it.
bool can_be_varied(const Parameter& parameter);

inline constexpr std::array sheet_counts{3, 5, 7, 9, 11, 15};
