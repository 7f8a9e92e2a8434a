#pragma once

#include "model/look/look.h"

#include <string>
#include <vector>

/// The displayed passes in addition to the last one; initially all.
struct PassSelection {
    bool are_all = true;
    std::vector<std::string> names = {};

    bool operator==(const PassSelection&) const = default;
    /// In the form of Executor::set_displayed.
    std::vector<bool> of(const Look& look) const;
};
