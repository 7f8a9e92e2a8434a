#pragma once

#include "model/look.h"

#include <optional>
#include <string>

/// Other values for the open look, to be seen beside the present ones.
struct Variant {
    Values values;
    std::string name;          // of its side
    std::string present_name;  // of the other side
    bool is_left = true;

    bool operator==(const Variant&) const = default;
    const std::string& left_name() const { return is_left ? name : present_name; }
    const std::string& right_name() const { return is_left ? present_name : name; }
};

/// The article's own picture beside ours, or ours beside the article's: every switch `as_written`
/// of the look, or of the looks of a stack, is turned. The article's is always on the left. None
/// for a look without such a switch.
std::optional<Variant> article_variant(const Look& look, const Values& values);
