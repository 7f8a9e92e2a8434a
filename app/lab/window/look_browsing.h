#pragma once

#include <string>

/// The filter of the list of looks.
struct LookBrowsing {
    std::string search;

    bool operator==(const LookBrowsing&) const = default;
};
