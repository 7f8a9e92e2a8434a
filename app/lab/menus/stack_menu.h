#pragma once

#include "lab/document/document.h"
#include "lab/library/library_view.h"
#include "lab/messages/menu_entry.h"

/// Changes of one look of a stack. Looks are identified by their tags, because positions can
/// change.
Edit bypass_part(const StackPart& part, const std::string& name);  // or enables it
Edit move_part(const StackPart& part, const std::string& name, int by);
Edit remove_part(const StackPart& part, const std::string& name);
Edit add_part(const ListedLook& look);

/// The names of the looks of a stack: "CRT", and "CRT 2" for a second one.
std::vector<std::string> part_names(const Stack& stack, const std::vector<ListedLook>& looks);

/// Whether the stack has commands for its looks.
bool has_stack_menu(const Stack& stack);

MenuSection stack_section(const Stack& stack, const std::vector<ListedLook>& looks);
