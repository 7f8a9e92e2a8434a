#pragma once

#include "lab/window/window_state.h"

#include <map>
#include <string>

/// The window layout for the session, as named numbers.
std::map<std::string, double> serialized_window(const WindowState& window);

/// The stored layout of a window with these panels. Missing or invalid numbers keep their defaults.
WindowState restored_window(const std::map<std::string, double>& numbers,
                            std::vector<PanelKind> panels = {});
