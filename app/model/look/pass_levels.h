#pragma once

#include "model/look/extent.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// The properties of a pass that identify the levels of a pyramid.
struct SizedName {
    std::string name;
    Extent extent;
};

/// "bloom_down_" for "bloom_down_3".
std::string name_without_number(const std::string& name);

/// The number of consecutive passes that are levels of one pyramid, for all passes in order; 1 for
/// a pass that is not a level. Levels are three or more passes. Their names end in a number that
/// increases or decreases by one, and their sizes only grow or only shrink.
std::vector<std::size_t> count_levels(std::span<const SizedName> passes);
