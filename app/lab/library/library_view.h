#pragma once

#include "lab/library/library.h"
#include "lab/library/look_templates.h"
#include "model/look/look.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// A preset with its displayed texts.
struct ListedLookPreset {
    PresetEntry entry;
    std::string name;
    std::string about;  // or the error if it cannot be read
};

/// A look and its presets with their displayed texts.
struct ListedLook {
    LookEntry entry;
    std::string name;
    std::string about;
    std::vector<ListedLookPreset> presets;

    /// Whether it is a stack that has presets; a stack has no folder.
    bool is_stack() const { return entry.folder.empty(); }
    /// The argument that opens it.
    std::string argument() const { return is_stack() ? entry.id : entry.folder.string(); }
};

/// The argument that opens the look again: a stack's id, a folder, or a foreign file.
std::string argument_of(const Look& look);
bool is_listed_as(const Look& look, const ListedLook& entry);

/// A snapshot of the library for display. It is updated once a second; only changed files are read.
class LibraryView {
public:
    /// `open`: appended if it is not in the library; null: no open look.
    void update(const Library& library, const Look* open, double wall_seconds);
    /// Makes the next update read the folders, after a file was saved, renamed or deleted.
    void refresh() { m_seconds_left = 0.0; }

    const std::vector<ListedLook>& looks() const { return m_looks; }
    const std::vector<LookTemplate>& templates() const { return m_templates; }
    /// The name and description in a file. A broken file keeps its last name; an empty name: it was
    /// never readable.
    struct Texts {
        std::filesystem::file_time_type written;
        std::string name;
        std::string about;
    };

private:
    void add_presets(ListedLook& look, const Library& library);
    void add_stacks(const Library& library);
    void add_open(const Library& library, const Look& open);
    const Texts& texts_of(const std::filesystem::path& file, bool is_look);

    double m_seconds_left = 0.0;
    std::string m_open;  // argument of the open look
    std::vector<ListedLook> m_looks;
    std::vector<LookTemplate> m_templates;
    std::map<std::filesystem::path, Texts> m_texts;
};
