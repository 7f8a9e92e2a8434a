#pragma once

#include "lab/storage/roots.h"

#include <functional>
#include <string>

/// Opens the window with a look ("" for the last one or the default).
using OpenWindow = std::function<int(const std::string& look, const DataFolders& data)>;

/// Runs `afterglow [LOOK]` or `afterglow COMMAND …`. Exit codes: 0 done; 1 error in a look or file,
/// or a failed comparison; 2 wrong usage.
int run_program(int argc, const char* const* argv, const OpenWindow& open_window);

/// Without a window: renders the look to a PNG in the working folder and prints its path.
int render_instead_of_window(const std::string& look, const DataFolders& data);
