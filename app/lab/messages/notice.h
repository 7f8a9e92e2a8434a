#pragma once

#include "base/diagnostic.h"
#include "base/source_excerpt.h"
#include "lab/messages/menu_entry.h"

#include <string>
#include <vector>

/// A diagnostic with its source lines.
struct Problem {
    Diagnostic diagnostic;
    SourceExcerpt excerpt = {};
};

/// A temporary message about an event (Saved "amber").
struct Notice {
    std::string text;
    bool is_problem = false;
    bool is_warning = false;  // playback continues
    double seconds_left = 6.0;
    std::string subject;  // the file or device of a problem, to withdraw it when solved
    std::vector<MenuEntry> buttons = {};
    bool goes_by = true;  // false: stays until dismissed
};
