#pragma once

#include "lab/library/shelf.h"
#include "lab/messages/choice.h"

class Lab;
struct WindowState;

/// Everything that there is to choose from now.
std::vector<ChoiceList> all_choices(const Lab& lab, const WindowState& window,
                                    const std::vector<ShelfLook>& looks);

/// Those of them that a menu has.
std::vector<ChoiceList> menu_choices(const Lab& lab, const WindowState& window,
                                     const std::vector<ShelfLook>& looks, ChoiceList::Place place);
