#pragma once

#include "model/look/spec.h"

#include <string>

/// Whether the user's signal or source is kept when a preset or another look is opened.
struct ContentLocks {
    bool signal = false;  // for looks that a signal drives
    bool source = false;  // for looks that process a picture

    bool operator==(const ContentLocks&) const = default;
};

/// The user's own signal and source.
struct Content {
    Spec signal;
    std::string source;
    ContentLocks locks;

    bool operator==(const Content&) const = default;
};
