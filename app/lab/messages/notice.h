#pragma once

#include "base/diagnostic.h"
#include "lab/messages/choice.h"

#include <string>
#include <vector>

/// A diagnostic with the line of text that it speaks of.
struct Problem {
    Diagnostic diagnostic;
    std::string source_line;
};

/// Something that just happened and goes by (Saved "amber").
struct Notice {
    std::string text;
    bool is_problem = false;
    double seconds_left = 6.0;
    std::string subject;  // of a problem: the file or device, so that it goes when that is mended
    std::vector<Choice> choices = {};  // what may be done about it
    bool goes_by = true;               // after its seconds; else it stays until it is put away
};
