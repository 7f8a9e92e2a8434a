#pragma once

#include "lab/window/window_state.h"

#include <map>
#include <string>

/// The arrangement of a window as the session keeps it: numbers by name.
std::map<std::string, double> remembered(const WindowState& window);

/// The arrangement that was remembered; what is missing or makes no sense is as in a new window.
WindowState restored_window(const std::map<std::string, double>& numbers);
