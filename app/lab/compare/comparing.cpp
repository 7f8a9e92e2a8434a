#include "lab/compare/comparing.h"

#include <algorithm>
#include <utility>

void Comparing::show_reference(bool is_reference_shown) {
    constexpr double seconds_after = 5.0;
    if (std::exchange(m_is_reference_shown, is_reference_shown) && !is_reference_shown)
        m_seconds_at_hand = seconds_after;
}

void Comparing::update(double seconds) {
    m_seconds_at_hand = std::max(m_seconds_at_hand - seconds, 0.0);
}

void Comparing::end() {
    m_chosen.mode = CompareMode::off;
    m_is_reference_shown = false;
    m_seconds_at_hand = 0.0;
}

const Slots& Comparing::slots(const std::string& look) const {
    static const Slots none;
    const auto found = m_slots.find(look);
    return found == m_slots.end() ? none : found->second;
}

void Comparing::set_slot(const std::string& look, std::size_t number, std::optional<Slot> slot) {
    m_slots[look].at(number) = std::move(slot);
    if (m_slots[look] == Slots{})
        m_slots.erase(look);
}

std::optional<Variant> Comparing::variant(const Other& other, const Look& look,
                                          const Values& values) const {
    if (other.kind == Other::Kind::article)
        return article_variant(look, values);
    if (other.kind == Other::Kind::file || other.slot >= slots(look.id).size())
        return std::nullopt;
    const std::optional<Slot>& slot = slots(look.id)[other.slot];
    return slot ? std::optional(slot_variant(look, *slot, other.slot)) : std::nullopt;
}

bool Comparing::is_there(const Other& other, const Look& look, const Values& values) const {
    if (other.kind == Other::Kind::file)
        return m_reference.picture() && m_reference.file() == other.file;
    return variant(other, look, values).has_value();
}

std::optional<Other> Comparing::nearest_other(const Look& look, const Values& values) const {
    std::vector<Other> others{m_chosen.other, Other{}};
    for (std::size_t i = 0; i < Slots{}.size(); ++i)
        others.push_back({Other::Kind::slot, i});
    const auto found = std::ranges::find_if(
        others, [&](const Other& other) { return is_there(other, look, values); });
    return found == others.end() ? std::nullopt : std::optional(*found);
}

Extent size_of_one(Extent view, CompareMode mode) {
    constexpr int line = 2;  // px
    if (mode != CompareMode::side_by_side)
        return view;
    return {std::max((view.width - line) / 2, 0), view.height};
}
