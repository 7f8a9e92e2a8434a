#pragma once

#include "model/look/look.h"
#include "model/preset/comparison.h"

#include <optional>
#include <string>

/// The names of the two pictures of a comparison, and which one is on the left.
struct Sides {
    std::string other;
    std::string current;
    bool is_other_left = true;

    bool operator==(const Sides&) const = default;
    const std::string& left_name() const { return is_other_left ? other : current; }
    const std::string& right_name() const { return is_other_left ? current : other; }
};

/// Other values for the open look, for comparison with the current ones.
struct Variant {
    Values values;
    Sides sides;

    bool operator==(const Variant&) const = default;
};

/// Compares the picture with the article's, or the article's with the corrected one. All switches
/// `as_written` of the look, or of the looks of a stack, get the opposite value. The article's
/// picture is always on the left. nullopt for a look without such a switch.
std::optional<Variant> article_variant(const Look& look, const Values& values);

/// The values of a slot, converted for the current look.
Values values_of(const Slot& slot, const Look& look);
Variant slot_variant(const Look& look, const Slot& slot, std::size_t number);
