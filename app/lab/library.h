#pragma once

#include "base/diagnostic.h"
#include "lab/roots.h"
#include "model/preset.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A look that is there to open.
struct LookEntry {
    std::string id;  // its folder's name
    std::filesystem::path folder;
    bool is_own = false;  // in the person's own folder
};

/// A preset that is there to open.
struct PresetEntry {
    std::string look;
    std::string name;  // the file's name without .json
    std::filesystem::path file;
    bool is_own = false;
};

/// The looks and presets on disk. Reads the folders at every call: files come and go under it.
class Library {
public:
    explicit Library(Roots roots) : m_roots(std::move(roots)) {}

    const Roots& roots() const { return m_roots; }
    std::vector<LookEntry> looks() const;                           // by id; the program's first
    std::vector<PresetEntry> presets(std::string_view look) const;  // by name; own ones shadow
    /// Ids of the stacks ("phosphor+crt") that have a folder of presets.
    std::vector<std::string> stacks() const;
    std::optional<LookEntry> find_look(std::string_view id) const;
    std::optional<PresetEntry> find_preset(std::string_view look, std::string_view name) const;

    /// Where a preset of that name would be written. The name may hold letters, digits, spaces and
    /// -_.()+ only, so that it is a file's name everywhere.
    Result<std::filesystem::path> preset_path(std::string_view look, std::string_view name) const;
    /// The same, refused where there is a preset of that name: in the folder, or one of the
    /// program's that it would hide.
    Result<std::filesystem::path> new_preset_path(std::string_view look,
                                                  std::string_view name) const;
    /// Each returns the file that is there afterwards; none overwrites another preset.
    Result<std::filesystem::path> save_preset(Preset preset, const std::string& name) const;
    Result<std::filesystem::path> rename_preset(const std::filesystem::path& file,
                                                const std::string& name) const;
    Result<std::filesystem::path> duplicate_preset(const std::filesystem::path& file) const;
    Result<void> delete_preset(const std::filesystem::path& file) const;

    /// Copies a look's folder under a new id; gives the new folder.
    Result<std::filesystem::path> duplicate_look(const std::filesystem::path& folder,
                                                 const std::string& id) const;
    /// A new look of one pass that already shows something.
    Result<std::filesystem::path> new_look(const std::string& id) const;

private:
    Result<std::filesystem::path> new_look_folder(const std::string& id) const;

    Roots m_roots;
};
