#pragma once

#include "model/look/extent.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// A pass by what tells levels of one pyramid from passes that are only numbered.
struct SizedName {
    std::string name;
    Extent extent;
};

/// "bloom_down_" of "bloom_down_3".
std::string name_without_number(const std::string& name);

/// How many passes behind each other are levels of one pyramid, of all of them in order: 1 for each
/// that is none. Levels are three or more whose names differ in the number at their end, which goes
/// up or down by one, and whose sizes go only up or only down.
std::vector<std::size_t> count_levels(std::span<const SizedName> passes);
