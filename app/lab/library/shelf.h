#pragma once

#include "lab/library/library.h"
#include "model/look/look.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// A preset as a list shows it.
struct ShelfPreset {
    PresetEntry entry;
    std::string name;
    std::string about;  // or why it cannot be read
};

/// A look and its presets as a list shows them.
struct ShelfLook {
    LookEntry entry;
    std::string name;
    std::string about;
    std::vector<ShelfPreset> presets;

    /// Looks one after the other that have presets; it has no folder of its own.
    bool is_stack() const { return entry.folder.empty(); }
    /// What opens it.
    std::string argument() const { return is_stack() ? entry.id : entry.folder.string(); }
};

/// What opens the look anew, as it has it: a stack's id, a folder, or the file of another program.
std::string argument_of(const Look& look);
bool is_listed_as(const Look& look, const ShelfLook& entry);

/// The library as the window lists it: read about once a second, and only files that changed.
class Shelf {
public:
    /// `open`: is listed behind all others where the library does not have it; null: none is.
    void update(const Library& library, const Look* open, double wall_seconds);
    /// Reads the folders at the next update: something was just saved, renamed or deleted.
    void refresh() { m_seconds_left = 0.0; }

    const std::vector<ShelfLook>& looks() const { return m_looks; }
    /// What a file says of itself: name and about; an empty name where it cannot be read.
    struct Words {
        std::filesystem::file_time_type written;
        std::string name;
        std::string about;
    };

private:
    void add_presets(ShelfLook& look, const Library& library);
    void add_stacks(const Library& library);
    void add_open(const Library& library, const Look& open);
    const Words& words_of(const std::filesystem::path& file, bool is_look);

    double m_seconds_left = 0.0;
    std::string m_open;  // what opens it
    std::vector<ShelfLook> m_looks;
    std::map<std::filesystem::path, Words> m_words;
};
