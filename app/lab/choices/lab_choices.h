#pragma once

#include "lab/library/shelf.h"
#include "lab/messages/choice.h"

class Lab;
struct WindowState;

/// All currently available choices.
std::vector<ChoiceList> all_choices(const Lab& lab, const WindowState& window,
                                    const std::vector<ShelfLook>& looks);

/// The choices of a menu.
std::vector<ChoiceList> menu_choices(const Lab& lab, const WindowState& window,
                                     const std::vector<ShelfLook>& looks, ChoiceList::Place place);
