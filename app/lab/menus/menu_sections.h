#pragma once

#include "lab/library/library_view.h"
#include "lab/messages/menu_entry.h"

struct LabParts;
struct WindowState;

/// All sections that are currently available.
std::vector<MenuSection> menu_sections(const LabParts& lab, const WindowState& window,
                                       const std::vector<ListedLook>& looks);

/// The sections of a menu.
std::vector<MenuSection> sections_of_menu(const LabParts& lab, const WindowState& window,
                                          const std::vector<ListedLook>& looks,
                                          MenuSection::Menu menu);
