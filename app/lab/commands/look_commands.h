#pragma once

#include "lab/commands/content_commands.h"
#include "lab/commands/pack_commands.h"
#include "lab/commands/pass_commands.h"
#include "lab/frame/workspace.h"
#include "lab/reload/look_loader.h"
#include "lab/storage/session_stash.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

struct Session;

/// Opens, creates and edits looks. Failures are shown as notices.
class LookCommands {
public:
    LookCommands(Workspace& work, LookLoader& loader, ContentCommands& content);

    /// Opens a look, stack or preset by id, name, file or line of text.
    void open(const std::string& argument);
    /// The same, but uses a preset's own signal or source even if the user's is locked.
    void open_with_content(const std::string& argument);
    /// Keeps the open look instead of the one that is being opened. Undo reverts a change of a
    /// stack.
    void cancel_opening();
    /// Hides the problems. Those of a look that could not be opened are replaced by those of the
    /// open one.
    void dismiss_problems();
    /// Opens any dropped or chosen file, or installs a pack.
    void open_file(const std::filesystem::path& file);
    /// Creates a look from a template and opens it. A notice shows its folder.
    void create(const std::string& id, const std::string& template_id);
    /// Why a new look can't have this id; "": it can.
    std::string problem_of_id(const std::string& id) const;
    /// A free id for a new look.
    std::string proposed_id() const;
    void duplicate(const std::string& id);
    /// Writes the pass overrides into look.json.
    void write_overrides();
    /// Offers to duplicate a shipped look in a folder that the user cannot write to.
    void open_in_editor(const Location& location);
    /// Shows the folder of the open look in the desktop's file manager.
    void show_in_folder();

    PackCommands& packs() { return m_packs; }
    const PackCommands& packs() const { return m_packs; }
    PassCommands& passes() { return m_passes; }
    const PassCommands& passes() const { return m_passes; }

    const std::vector<std::filesystem::path>& include_folders() const { return m_includes; }
    /// The user's folders for includes, in addition to those of --include. They are stored.
    void set_include_folders(const std::vector<std::filesystem::path>& folders);

    /// Unsaved changes of looks that were closed.
    const SessionStash& stash() const { return m_stash; }
    SessionStash& stash() { return m_stash; }
    /// Stores unsaved changes, if any, and shows a notice.
    void stash_unsaved(const Session& session,
                       const std::function<std::optional<Picture>()>& picture = {});

private:
    bool must_duplicate(const std::filesystem::path& file) const;
    void report_created(const std::filesystem::path& folder);
    void search_includes();

    Workspace& m_work;
    LookLoader& m_loader;
    ContentCommands& m_content;
    std::vector<std::filesystem::path> m_includes;
    SessionStash m_stash;
    PackCommands m_packs{m_work};
    PassCommands m_passes{m_work};
};
