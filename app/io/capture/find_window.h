#pragma once

#include "io/capture/x_server.h"

#include <string>

/// The window of another program with this title, or with this part of a title in any case. An
/// equal title wins, then the topmost window. Errors have no file and list the windows.
Result<XWindow> find_window(const XServer& server, const std::string& title);
