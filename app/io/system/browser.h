#pragma once

#include "base/diagnostic.h"

#include <atomic>
#include <filesystem>
#include <string>

/// The command of an installed Chromium or Chrome; "" if there is none.
std::string find_browser();

/// How a page is run.
struct BrowserRun {
    std::string url;
    std::filesystem::path profile;  // an empty folder of its own
    double seconds = 60.0;          // timeout
    bool uses_software = false;     // its own software GL instead of the system's GL
    const std::atomic<bool>* is_cancelled = nullptr;
};

/// Runs a page without a window, without network and without the user's profile. Returns the page's
/// HTML after its scripts have run. Errors have no file: the browser is missing, or too slow.
Result<std::string> run_in_browser(const BrowserRun& run);
