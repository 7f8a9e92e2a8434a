#pragma once

#include "model/look/look.h"
#include "model/preset/comparison.h"

#include <optional>
#include <string>

/// How the two pictures of a comparison are called, and which of them is on the left.
struct Sides {
    std::string other;
    std::string present;
    bool is_other_left = true;

    bool operator==(const Sides&) const = default;
    const std::string& left_name() const { return is_other_left ? other : present; }
    const std::string& right_name() const { return is_other_left ? present : other; }
};

/// Other values for the open look, to be seen beside the present ones.
struct Variant {
    Values values;
    Sides sides;

    bool operator==(const Variant&) const = default;
};

/// The article's own picture beside ours, or ours beside the article's: every switch `as_written`
/// of the look, or of the looks of a stack, is turned. The article's is always on the left. None
/// for a look without such a switch.
std::optional<Variant> article_variant(const Look& look, const Values& values);

/// A slot's values, as the look takes them now.
Values values_of(const Slot& slot, const Look& look);
Variant slot_variant(const Look& look, const Slot& slot, std::size_t number);
