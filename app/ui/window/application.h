#pragma once

#include "base/diagnostic.h"
#include "lab/storage/roots.h"

#include <filesystem>
#include <optional>
#include <string>

/// The options for the start of the window.
struct ApplicationOptions {
    std::optional<std::string> look;  // name, folder or preset; nullopt: session, else Phosphor
    Roots roots;
    /// Kept up to date with the displayed state, for tests; "": not written.
    std::filesystem::path state_file;
};

/// Opens the window and returns when it is closed. Fails before displaying anything if the display
/// or OpenGL 4.1 is missing.
Result<void> run_window(const ApplicationOptions& options);
