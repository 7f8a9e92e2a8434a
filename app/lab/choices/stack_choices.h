#pragma once

#include "lab/document/document.h"
#include "lab/library/shelf.h"
#include "lab/messages/choice.h"

/// Changes of one look of a stack. Looks are identified by their tags, because positions can
/// change.
Deed bypass_part(const StackPart& part, const std::string& name);  // or enables it
Deed move_part(const StackPart& part, const std::string& name, int by);
Deed remove_part(const StackPart& part, const std::string& name);
Deed add_part(const ShelfLook& look);

/// The names of the looks of a stack: "CRT", and "CRT 2" for a second one.
std::vector<std::string> part_names(const Stack& stack, const std::vector<ShelfLook>& looks);

/// Whether the stack has commands for its looks.
bool is_worth_listing(const Stack& stack);

ChoiceList stack_choices(const Stack& stack, const std::vector<ShelfLook>& looks);
