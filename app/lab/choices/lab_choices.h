#pragma once

#include "lab/library/library_view.h"
#include "lab/messages/choice.h"

class Lab;
struct WindowState;

/// All currently available choices.
std::vector<ChoiceList> all_choices(const Lab& lab, const WindowState& window,
                                    const std::vector<ListedLook>& looks);

/// The choices of a menu.
std::vector<ChoiceList> menu_choices(const Lab& lab, const WindowState& window,
                                     const std::vector<ListedLook>& looks, ChoiceList::Place place);
