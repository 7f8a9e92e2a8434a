#pragma once

#include "model/look/spec.h"

#include <string>

/// Whether the user's signal or source stays when a preset or another look is opened.
struct ContentLocks {
    bool signal = false;  // in looks that a signal drives
    bool source = false;  // in looks that process a picture

    bool operator==(const ContentLocks&) const = default;
};

/// What the user views through looks, one of each kind.
struct Content {
    Spec signal;
    std::string source;
    ContentLocks locks;

    bool operator==(const Content&) const = default;
};
