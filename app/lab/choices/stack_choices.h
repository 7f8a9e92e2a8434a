#pragma once

#include "lab/document/document.h"
#include "lab/library/shelf.h"
#include "lab/messages/choice.h"

/// What can be done to a look of a stack. Looks are told by their tags: what a person chose may
/// have moved since.
Deed bypass_part(const StackPart& part, const std::string& name);  // or draws it again
Deed move_part(const StackPart& part, const std::string& name, int by);
Deed remove_part(const StackPart& part, const std::string& name);
Deed add_part(const ShelfLook& look);

/// What each look of a stack is called: "CRT", and "CRT 2" for a second one.
std::vector<std::string> part_names(const Stack& stack, const std::vector<ShelfLook>& looks);

/// Whether there is something to do about the looks that are there.
bool is_worth_listing(const Stack& stack);

ChoiceList stack_choices(const Stack& stack, const std::vector<ShelfLook>& looks);
