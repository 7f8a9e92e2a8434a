#pragma once

#include "io/files/trash.h"
#include "lab/commands/preset_navigation.h"
#include "lab/commands/preset_sharing.h"

#include <optional>
#include <string>
#include <vector>

/// Commands for presets as files: save, rename, duplicate, delete, star.
class PresetCommands {
public:
    PresetCommands(Workspace& work, LookLoader& loader, ContentCommands& content)
        : m_work(work),
          m_loader(loader),
          m_navigation(work, loader, content),
          m_sharing(work, loader, content) {}

    PresetNavigation& navigation() { return m_navigation; }
    const PresetNavigation& navigation() const { return m_navigation; }
    PresetSharing& sharing() { return m_sharing; }
    const PresetSharing& sharing() const { return m_sharing; }

    /// Whether save() overwrites the open preset: it is the user's own JSON file.
    bool can_save_over() const;
    /// The initial name of "Save preset as", such as "Amber P3 (mine)" for a shipped preset.
    std::string proposed_name() const;
    /// Overwrites the open preset if can_save_over().
    void save();
    /// Saves to the user's folder. Refused if the user has a preset of that name.
    void save_as(const std::string& name);
    /// The same, but overwrites the existing preset.
    void replace(const std::string& name);
    /// The folder that save_as() writes to.
    std::filesystem::path destination() const;

    /// Whether the shipped presets are in a writable source checkout.
    bool has_source_checkout() const;
    /// Overwrites the open shipped preset, or saves the open preset to the shipped ones under its
    /// name.
    void save_into_shipped();

    void rename(const std::filesystem::path& file, const std::string& name);
    /// Unsaved changes of the open preset continue as changes of the copy.
    void duplicate(const std::filesystem::path& file);
    /// Moves it to the desktop's trash; undo() restores it.
    void remove(const std::filesystem::path& file);
    /// Shows it in the desktop's file manager.
    void show_in_folder(const std::filesystem::path& file);

    /// Restores the preset that was deleted last, or undoes the document's step: the newer one.
    void undo();
    /// Delete "Amber", if undo() would restore it; otherwise "".
    std::string undo_name() const;

    /// Shows a notice once per start if presets of the user are in the program's folder, and offers
    /// to move them.
    void offer_move();
    void move_to_user_folder();

private:
    struct Removal {
        TrashedFile trashed;
        std::string look;
        std::string name;
        bool has_star = false;
        std::optional<Preset> identity;  // of the document, if the preset was open
        DocumentState saved;
        std::size_t steps = 0;  // number of undo steps at that time
    };

    bool undo_removal();  // false: the next step is the document's
    void save_to(const std::filesystem::path& file, const std::string& name);
    bool is_open(const std::filesystem::path& file) const;
    std::string star_name(const std::filesystem::path& file) const;
    const Removal* last_removal() const;

    Workspace& m_work;
    LookLoader& m_loader;
    PresetNavigation m_navigation;
    PresetSharing m_sharing;
    std::vector<Removal> m_removals;
};
