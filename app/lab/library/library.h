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

/// A look that is there to open.
struct LookEntry {
    std::string id;  // its folder's name
    std::filesystem::path folder;
    bool is_shipped = false;
};

/// A preset that is there to open.
struct PresetEntry {
    std::string look;
    std::string name;  // the file's name without .json
    std::filesystem::path file;
    bool is_shipped = false;  // else the user's
    std::string id = {};  // unique within the look: the name, or "user:NAME" beside a shipped one
};

/// The order of lists: the user's presets, then the shipped ones, each by the name that is shown.
bool is_listed_before(const PresetEntry& one, std::string_view one_name, const PresetEntry& other,
                      std::string_view other_name);

/// The looks and presets on disk. Reads the folders at every call, as files come and go.
class Library {
public:
    explicit Library(Roots roots, ShippedFiles shipped = files_of_build())
        : m_roots(std::move(roots)),
          m_shipped(std::make_shared<const ShippedFiles>(std::move(shipped))) {}

    const Roots& roots() const { return m_roots; }
    std::vector<LookEntry> looks() const;  // by id; the program's first
    /// The user's first, then the shipped ones, each by file name. Equal names stand in both.
    std::vector<PresetEntry> presets(std::string_view look) const;
    /// Ids of the stacks ("phosphor+crt") that have a folder of presets.
    std::vector<std::string> stacks() const;
    std::optional<LookEntry> find_look(std::string_view id) const;
    /// By name: the shipped one, else the user's. "shipped:NAME" and "user:NAME" are exact.
    std::optional<PresetEntry> find_preset(std::string_view look, std::string_view name) const;
    /// Whether a file lies in the program's folder as it was shipped.
    bool is_shipped(const std::filesystem::path& file) const;
    /// The user's presets in the program's folder, where older programs wrote them.
    std::vector<PresetEntry> presets_in_program_folder() const;
    /// Moves a preset into the user's folder, under a free name. Gives the new file.
    Result<std::filesystem::path> move_to_user_folder(const PresetEntry& preset) const;

    /// Where a new preset of that name is written: in the user's folder. The name may hold letters,
    /// digits, spaces and
    /// -_.()+ only, so that it is a file's name everywhere.
    Result<std::filesystem::path> preset_path(std::string_view look, std::string_view name) const;
    /// The same, refused where the user has a preset of that name.
    Result<std::filesystem::path> new_preset_path(std::string_view look,
                                                  std::string_view name) const;
    /// Each returns the file that is there afterwards; none overwrites another preset.
    Result<std::filesystem::path> save_preset(Preset preset, const std::string& name) const;
    Result<std::filesystem::path> rename_preset(const std::filesystem::path& file,
                                                const std::string& name) const;
    Result<std::filesystem::path> duplicate_preset(const std::filesystem::path& file) const;

    /// Copies a look's folder under a new id; gives the new folder.
    Result<std::filesystem::path> duplicate_look(const std::filesystem::path& folder,
                                                 const std::string& id) const;
    /// A new look of one pass that already shows something.
    Result<std::filesystem::path> new_look(const std::string& id) const;

private:
    Result<std::filesystem::path> new_look_folder(const std::string& id) const;

    Roots m_roots;
    std::shared_ptr<const ShippedFiles> m_shipped;
};
