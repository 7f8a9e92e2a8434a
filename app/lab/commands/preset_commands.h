#pragma once

#include "io/files/trash.h"
#include "lab/commands/preset_navigation.h"
#include "lab/commands/preset_sharing.h"

#include <optional>
#include <string>
#include <vector>

/// What the user does with presets as files: save, rename, duplicate, delete, star.
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

    /// Whether save() writes over the open preset: it is the user's own JSON file.
    bool can_save_over() const;
    /// What "Save preset as" begins with: "Amber P3 (mine)" beside a shipped preset.
    std::string proposed_name() const;
    /// Over the open preset, where can_save_over().
    void save();
    /// Into the user's folder; refused where the user has one of that name.
    void save_as(const std::string& name);
    /// The same over the one there is.
    void replace(const std::string& name);
    /// The folder that save_as() writes to.
    std::filesystem::path destination() const;

    /// Whether the shipped presets lie in a source checkout that can be written to.
    bool has_source_checkout() const;
    /// Over the shipped preset that is open, or beside it under the open preset's name.
    void save_into_shipped();

    void rename(const std::filesystem::path& file, const std::string& name);
    /// Unsaved changes of the open preset go on as changes to the copy.
    void duplicate(const std::filesystem::path& file);
    /// To the desktop's trash; undo() brings it back.
    void remove(const std::filesystem::path& file);
    /// In the desktop's file manager.
    void show_in_folder(const std::filesystem::path& file);

    /// Brings the preset back that was deleted last, where nothing was changed since. False: there
    /// is none, and the document's own step is next.
    bool undo_removal();
    /// Delete "Amber", where undo_removal() would do something; else "".
    std::string undo_name() const;

    /// Says once a start that presets of the user lie in the program's folder, and offers to move
    /// them.
    void offer_move();
    void move_to_user_folder();

private:
    struct Removal {
        TrashedFile trashed;
        std::string look;
        std::string name;
        bool has_star = false;
        std::optional<Preset> identity;  // of the document, where the preset was open
        DocumentState saved;
        std::size_t steps = 0;  // of undo that there were
    };

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
