#pragma once

#include "lab/library/library_view.h"
#include "lab/messages/menu_entry.h"
#include "model/look/look.h"

#include <string>
#include <string_view>
#include <vector>

/// An entry of the command palette.
struct PaletteEntry {
    enum class Kind { action, look, preset, pass, parameter, menu_entry, file, difference };

    Kind kind = Kind::action;
    std::string id;               // for the recent list: "Undo", "parameter:decay"
    std::string label;            // "Undo: Decay", "Parameter: Decay"
    std::string detail;           // menu, group, or look of a preset
    std::string subject;          // argument to open, or name of pass or parameter; "": an action
    std::string keys;             // "Ctrl+Z"
    std::string disabled_reason;  // why it is disabled; "": enabled
    MenuEntry menu_entry = {};    // for the kind `menu_entry`
};

/// All entries except actions: the presets, passes and parameters of the open look, then all looks
/// and their presets. `open` may be null.
std::vector<PaletteEntry> palette_entries(const Look* open, const std::vector<ListedLook>& looks);

/// All entries of menu sections; the id is the label. Duplicates are removed.
std::vector<PaletteEntry> section_entries(const std::vector<MenuSection>& sections);

/// The recent files, and the presets that can be compared with the open document.
std::vector<PaletteEntry> file_entries(const std::vector<std::string>& recent);
std::vector<PaletteEntry> difference_entries(const Look& open,
                                             const std::vector<ListedLook>& looks);

/// An entry that matches the query.
struct PaletteMatch {
    std::size_t entry = 0;
    std::vector<std::size_t> positions;  // matching bytes of its label
};

/// The matches of `query`, the best first. In a tie, files are last. The others are sorted by last
/// use (`used`: ids, last used first), then entries that are not of menus, then shorter names. An
/// empty query returns all entries, the used ones first.
std::vector<PaletteMatch> find_entries(const std::vector<PaletteEntry>& entries,
                                       std::string_view query,
                                       const std::vector<std::string>& used);

/// Moves an id to the front of the used ones, if it is not there; keeps 20.
void note_use(std::vector<std::string>& used, const std::string& id);
