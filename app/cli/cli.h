#pragma once

#include "lab/storage/roots.h"

#include <functional>
#include <string>

/// Opens the window on a look ("" for the last one or the default).
using OpenWindow = std::function<int(const std::string& look, const DataFolders& data)>;

/// Runs `afterglow [LOOK]` or `afterglow COMMAND …`. Exit codes: 0 done; 1 the look, file or
/// comparison is not good; 2 wrong usage.
int run_program(int argc, const char* const* argv, const OpenWindow& open_window);

/// Without a window: renders the look to a PNG in the working folder and says where it is.
int render_instead_of_window(const std::string& look, const DataFolders& data);
