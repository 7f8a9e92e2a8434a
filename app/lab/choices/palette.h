#pragma once

#include "lab/library/shelf.h"
#include "lab/messages/choice.h"
#include "model/look/look.h"

#include <string>
#include <string_view>
#include <vector>

/// One thing that a person may ask for by its name.
struct PaletteEntry {
    enum class Kind { action, look, preset, pass, parameter, choice, file, difference };

    Kind kind = Kind::action;
    std::string id;       // it is remembered by: "Undo", "parameter:decay"
    std::string label;    // "Undo: Decay", "Parameter: Decay"
    std::string detail;   // where it belongs: a menu, a group, the look of a preset
    std::string subject;  // what opens it, or the name of the pass or parameter; "" for an action
    std::string keys;     // "Ctrl+Z"
    std::string why_not;  // it cannot be had now; "": it can
    Choice choice = {};   // of that kind
};

/// Everything but the actions: the presets of the open look, its passes and parameters, then the
/// looks and their presets. `open` may be null.
std::vector<PaletteEntry> palette_entries(const Look* open, const std::vector<ShelfLook>& looks);

/// All that can be chosen from lists; its id is its label. What a list has twice comes once.
std::vector<PaletteEntry> choice_entries(const std::vector<ChoiceList>& lists);

/// Files that were opened lately, and which presets can be compared with what is open.
std::vector<PaletteEntry> file_entries(const std::vector<std::string>& recent);
std::vector<PaletteEntry> difference_entries(const Look& open, const std::vector<ShelfLook>& looks);

/// An entry that fits what was typed.
struct PaletteMatch {
    std::size_t entry = 0;
    std::vector<std::size_t> places;  // the bytes of its label that fit
};

/// What fits `query`, the best first; of two that fit as well the one used later (`used`: ids, the
/// last used first), then what is no choice from a list, then the one with the shorter name. All of
/// them for an empty query: those used, then the others in their order.
std::vector<PaletteMatch> find_entries(const std::vector<PaletteEntry>& entries,
                                       std::string_view query,
                                       const std::vector<std::string>& used);

/// Puts an entry's id first among those used; keeps some twenty.
void note_use(std::vector<std::string>& used, const std::string& id);
