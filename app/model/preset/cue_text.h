#pragma once

#include <string>

/// A cue file as the user edits it.
struct CueText {
    std::string file = {};  // "": not saved yet
    std::string text = {};

    bool operator==(const CueText&) const = default;
    bool is_empty() const { return file.empty() && text.empty(); }
};
