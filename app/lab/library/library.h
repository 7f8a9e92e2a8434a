#pragma once

#include "base/diagnostic.h"
#include "lab/library/shipped_files.h"
#include "lab/storage/roots.h"
#include "model/preset/preset.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// An available look.
struct LookEntry {
    std::string id;                // folder name
    std::filesystem::path folder;  // or the file of a look of another program
    bool is_shipped = false;
    // Of a look of another program: its folder in shaders/, with all its files; otherwise "".
    std::filesystem::path foreign_folder = {};
};

/// An available preset.
struct PresetEntry {
    std::string look;
    std::string name;  // file name without .json
    std::filesystem::path file;
    bool is_shipped = false;  // false: the user's
    std::string id = {};      // unique within the look: name or "user:NAME"
};

/// The order of lists: the user's presets, the shipped ones, and those of the articles ("article",
/// "article-mono"), each by displayed name.
bool is_listed_before(const PresetEntry& one, std::string_view one_name, const PresetEntry& other,
                      std::string_view other_name);

/// The looks and presets on disk. Each call reads the folders, because files can change.
class Library {
public:
    /// `added` are looks outside the roots. They take precedence over others with the same id.
    explicit Library(Roots roots, ShippedFiles shipped = files_of_build(),
                     std::vector<LookEntry> added = {})
        : m_roots(std::move(roots)),
          m_shipped(std::make_shared<const ShippedFiles>(std::move(shipped))),
          m_added(std::move(added)) {}

    /// The same library with further looks outside the roots.
    Library with(std::vector<LookEntry> added) const;
    const Roots& roots() const { return m_roots; }
    std::vector<LookEntry> looks() const;  // by id; the program's first
    /// The user's presets, then the shipped ones, each by file name. A name can occur in both.
    std::vector<PresetEntry> presets(std::string_view look) const;
    /// The ids of stacks ("phosphor+crt") that have a folder of presets.
    std::vector<std::string> stacks() const;
    std::optional<LookEntry> find_look(std::string_view id) const;
    /// By name: the shipped preset, otherwise the user's. "shipped:NAME" and "user:NAME" are exact.
    std::optional<PresetEntry> find_preset(std::string_view look, std::string_view name) const;
    /// Whether a file in the program's folder is unchanged since it was shipped.
    bool is_shipped(const std::filesystem::path& file) const;
    /// The user's presets in the program's folder, where older versions stored them.
    std::vector<PresetEntry> presets_in_program_folder() const;
    /// Moves a preset to the user's folder under a free name. Returns the new file.
    Result<std::filesystem::path> move_to_user_folder(const PresetEntry& preset) const;

    /// The file in the user's folder for a new preset with this name. The name may contain only
    /// letters, digits, spaces and -_.()+, so that it is valid on every file system.
    Result<std::filesystem::path> preset_path(std::string_view look, std::string_view name) const;
    /// The same; fails if the user already has a preset with this name.
    Result<std::filesystem::path> new_preset_path(std::string_view look,
                                                  std::string_view name) const;
    /// Each returns the resulting file; none overwrites another preset.
    Result<std::filesystem::path> save_preset(Preset preset, const std::string& name) const;
    Result<std::filesystem::path> rename_preset(const std::filesystem::path& file,
                                                const std::string& name) const;
    Result<std::filesystem::path> duplicate_preset(const std::filesystem::path& file) const;

    /// Copies the folder of a look under a new id; returns the new folder.
    Result<std::filesystem::path> duplicate_look(const std::filesystem::path& folder,
                                                 const std::string& id) const;
    /// Creates a look from a template, see look_templates(). It already draws a picture.
    Result<std::filesystem::path> new_look(const std::string& id,
                                           std::string_view template_id) const;
    /// Whether a new look can have this id, and why not.
    Result<void> check_look_name(const std::string& id) const;

private:
    Result<std::filesystem::path> new_look_folder(const std::string& id) const;

    Roots m_roots;
    std::shared_ptr<const ShippedFiles> m_shipped;
    std::vector<LookEntry> m_added;
};
