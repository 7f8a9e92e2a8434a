#pragma once

#include "lab/compare/reference_picture.h"
#include "lab/compare/variant.h"

#include <optional>
#include <string>
#include <vector>

/// The user's comparison: the chosen reference, the slots of all looks, and the picture from a
/// file.
class Comparing {
public:
    const Comparison& chosen() const { return m_chosen; }
    void choose(Comparison comparison) { m_chosen = std::move(comparison); }

    /// Shows the reference instead of the picture while this is on.
    void show_reference(bool is_reference_shown);
    bool is_reference_shown() const { return m_is_reference_shown; }
    /// Whether the reference must be ready: also for a while after a flash, so that the next one is
    /// shown immediately.
    bool is_wanted() const {
        return m_chosen.mode != CompareMode::off || m_is_reference_shown || m_seconds_at_hand > 0.0;
    }
    void update(double seconds);
    /// Ends the comparison.
    void end();

    const LookSlots& all_slots() const { return m_slots; }
    void set_slots(LookSlots slots) { m_slots = std::move(slots); }
    const Slots& slots(const std::string& look) const;
    void set_slot(const std::string& look, std::size_t number, std::optional<Slot> slot);

    ReferencePicture& reference() { return m_reference; }
    const ReferencePicture& reference() const { return m_reference; }

    /// The values of the reference. nullopt for a picture from a file, for an empty slot, and for a
    /// look without a switch `as_written`.
    std::optional<Variant> variant(const Other& other, const Look& look,
                                   const Values& values) const;
    /// The available reference: the chosen one, otherwise the article's picture, otherwise the
    /// first slot that is not empty. nullopt: none.
    std::optional<Other> nearest_other(const Look& look, const Values& values) const;

private:
    bool is_there(const Other& other, const Look& look, const Values& values) const;

    Comparison m_chosen;
    bool m_is_reference_shown = false;
    double m_seconds_at_hand = 0.0;
    LookSlots m_slots;
    ReferencePicture m_reference;
};

/// The size of each picture in a view of this size: the whole view, or a half next to a line.
Extent size_of_one(Extent view, CompareMode mode);
