#pragma once

#include "base/diagnostic.h"
#include "lab/storage/roots.h"

#include <filesystem>
#include <optional>
#include <string>

/// What the window is to start with.
struct WindowOptions {
    std::optional<std::string> look;  // folder, name or preset; none: the session's, else Phosphor
    Roots roots;
    /// Kept up to date with what the window shows, for tests; "": none.
    std::filesystem::path state_file;
};

/// Opens the window and stays until it is closed. Fails before anything is shown where there is no
/// display or no OpenGL 4.1.
Result<void> run_window(const WindowOptions& options);
