#pragma once

#include "lab/compare/reference_picture.h"
#include "lab/compare/variant.h"

#include <optional>
#include <string>
#include <vector>

/// What a person compares the present picture with: their choice, the slots of every look, and the
/// picture from a file.
class Comparing {
public:
    const Comparison& chosen() const { return m_chosen; }
    void choose(Comparison comparison) { m_chosen = std::move(comparison); }

    /// Shows the other picture in the place of ours for as long as this lasts.
    void flash(bool is_flashing);
    bool is_flashing() const { return m_is_flashing; }
    /// Whether the other picture is to be at hand: also for a while after a flash, so that the next
    /// one is there at once.
    bool is_wanted() const {
        return m_chosen.mode != CompareMode::off || m_is_flashing || m_seconds_at_hand > 0.0;
    }
    void pass_time(double seconds);
    /// Nothing is compared any more.
    void end();

    const LookSlots& all_slots() const { return m_slots; }
    void set_slots(LookSlots slots) { m_slots = std::move(slots); }
    const Slots& slots(const std::string& look) const;
    void set_slot(const std::string& look, std::size_t number, std::optional<Slot> slot);

    ReferencePicture& reference() { return m_reference; }
    const ReferencePicture& reference() const { return m_reference; }

    /// The values that are compared with: none for a picture from a file, for an empty slot, and
    /// for a look without a switch `as_written`.
    std::optional<Variant> variant(const Other& other, const Look& look,
                                   const Values& values) const;
    /// What there is to compare with: what was chosen, else the article's picture, else the first
    /// slot that is not empty.
    std::optional<Other> nearest_other(const Look& look, const Values& values) const;

private:
    bool is_there(const Other& other, const Look& look, const Values& values) const;

    Comparison m_chosen;
    bool m_is_flashing = false;
    double m_seconds_at_hand = 0.0;
    LookSlots m_slots;
    ReferencePicture m_reference;
};

/// How large one of the pictures is that share a view of that size: all of it, or a half beside a
/// line.
Extent room_of_one(Extent view, CompareMode mode);
