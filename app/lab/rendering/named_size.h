#pragma once

#include "model/look/extent.h"

#include <optional>
#include <string>
#include <vector>

/// A usual size of a picture.
struct NamedSize {
    std::string name;   // on the command line
    std::string label;  // in the window
    Extent extent;
};

const std::vector<NamedSize>& named_sizes();

/// The size of a name or of a text such as "1280x720"; nullopt: neither, or beyond 1 to 16384 px.
std::optional<Extent> parse_extent(const std::string& text);
